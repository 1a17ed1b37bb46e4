/* Asks for a file: by the desktop's dialog where zenity or kdialog is there, else by a list of folders of
 * our own. */
#ifndef VIEWER_FILE_DIALOG_H
#define VIEWER_FILE_DIALOG_H

#include <stdbool.h>
#include <stdio.h>

/* Zeroed: not open. */
struct file_dialog {
    FILE *answer;    /* of the desktop's dialog, while it is open */
    char text[4096]; /* of it, so far */
    size_t length;
    bool is_open; /* our own is */
    char *folder; /* that it shows */
    char **names; /* in it; folders end in a slash and come first */
    int count;
    int chosen;        /* of the names, to be taken by Enter; -1 = none */
    bool seeks;        /* the list has to scroll to it */
    bool was_moved;    /* it was chosen in the list after the last letter was typed */
    char typed[1024];  /* a name, its beginning, or a path */
    char problem[256]; /* of the last Enter; "" = none */
};

/* Begins in the folder of the file; NULL: in the working folder. */
void file_dialog_open(struct file_dialog *dialog, const char *beside);

/* The file that was chosen in the desktop's dialog, to be freed; NULL = none yet, or none at all. */
char *file_dialog_poll(struct file_dialog *dialog);

/* Our own: a click on the n-th name. Enters a folder (NULL), or ends and gives the file, to be freed. */
char *file_dialog_choose(struct file_dialog *dialog, int n);

/* Our own: chooses the first name that begins as what was typed, in upper or lower case. */
void file_dialog_search(struct file_dialog *dialog);

/* Our own: chooses so many names further on. */
void file_dialog_move(struct file_dialog *dialog, int by);

/* Our own: shows another folder; the folder above. "~" is the user's. */
void file_dialog_enter(struct file_dialog *dialog, const char *folder);
void file_dialog_leave(struct file_dialog *dialog);

/* Our own: takes what was typed, as a path or a name, else the name that is chosen, as file_dialog_choose. */
char *file_dialog_accept(struct file_dialog *dialog);

/* Closes it, and frees what it has. Accepts zeroed ones. */
void file_dialog_close(struct file_dialog *dialog);

#endif
