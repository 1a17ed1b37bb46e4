/* Asks for a file by the desktop's dialog: zenity or kdialog. */
#ifndef VIEWER_FILE_DIALOG_H
#define VIEWER_FILE_DIALOG_H

#include <stdbool.h>
#include <stdio.h>

/* Zeroed: not open. */
struct file_dialog {
    FILE *answer;    /* of the desktop's dialog, while it is open */
    char text[4096]; /* of it, so far */
    size_t length;
};

/* Begins in the folder of the file. Error: the desktop has no dialog. */
bool file_dialog_open(struct file_dialog *dialog, const char *beside);

/* The file that was chosen, to be freed; NULL = none yet, or none at all. */
char *file_dialog_poll(struct file_dialog *dialog);

/* Waits for the desktop's dialog to end. Accepts zeroed ones. */
void file_dialog_close(struct file_dialog *dialog);

#endif
