/* Opens the desktop's dialog of files: zenity or kdialog. */
#ifndef VIEWER_FILE_DIALOG_H
#define VIEWER_FILE_DIALOG_H

#include <stdbool.h>
#include <stdio.h>

/* A dialog. Zeroed: not open. */
struct file_dialog {
    FILE *answer;    /* output of the dialog's process; NULL: not open */
    char text[4096]; /* read so far */
    size_t length;
};

/* Opens the dialog in the folder of a file. Error: the desktop has no dialog. */
bool file_dialog_open(struct file_dialog *dialog, const char *beside);

/* Returns the chosen file, which the caller frees. NULL: still open, or cancelled. */
char *file_dialog_poll(struct file_dialog *dialog);

/* Waits until the dialog ends. Accepts a zeroed one. */
void file_dialog_close(struct file_dialog *dialog);

#endif
