/* Asks for a file: by the desktop's dialog where zenity or kdialog is there, else by a list of folders of
 * our own. */
#ifndef VIEWER_FILE_DIALOG_H
#define VIEWER_FILE_DIALOG_H

#include <stdbool.h>
#include <stdio.h>

enum { FOLDER_ENTRIES_MAX = 512 };

/* Zeroed: not open. */
struct file_dialog {
    FILE *answer;    /* of the desktop's dialog, while it is open */
    char text[4096]; /* of it, so far */
    size_t length;
    bool is_open;                    /* our own is */
    char *folder;                    /* that it shows */
    char *names[FOLDER_ENTRIES_MAX]; /* in it; folders end in a slash and come first */
    int count;
};

void file_dialog_open(struct file_dialog *dialog);

/* Whether a dialog is there, of whatever kind. */
bool file_dialog_is_open(const struct file_dialog *dialog);

/* The file that was chosen in the desktop's dialog, to be freed; NULL = none yet, or none at all. */
char *file_dialog_poll(struct file_dialog *dialog);

/* Our own: a click on the n-th name. Enters a folder (NULL), or ends and gives the file, to be freed. */
char *file_dialog_choose(struct file_dialog *dialog, int n);

/* Closes it, and frees what it has. Accepts zeroed ones. */
void file_dialog_close(struct file_dialog *dialog);

#endif
