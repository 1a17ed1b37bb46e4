#define _GNU_SOURCE
#include "viewer/files/file_dialog.h"

#include "base/error.h"
#include "base/memory.h"
#include "base/shell.h"

#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* Each begins in the shell's folder. */
static const char *const commands[][2] = {
    {"zenity", "zenity --file-selection --title='Open'"},
    {"kdialog", "kdialog --getopenfilename ."},
};

static bool ask_desktop(struct file_dialog *dialog, const char *folder) {
    for (size_t i = 0; i < sizeof commands / sizeof *commands; i++)
        if (shell_has(commands[i][0])) {
            char *quoted = shell_quote(folder);
            char *command = mem_printf("cd -- %s; %s 2>/dev/null", quoted, commands[i][1]);
            dialog->answer = popen(command, "re");
            mem_free(quoted, command);
            dialog->length = 0;
            if (dialog->answer)
                fcntl(fileno(dialog->answer), F_SETFL, O_NONBLOCK);
            return dialog->answer;
        }
    return false;
}

char *file_dialog_poll(struct file_dialog *dialog) {
    if (!dialog->answer)
        return NULL;
    size_t room = sizeof dialog->text - 1 - dialog->length;
    ssize_t got = read(fileno(dialog->answer), dialog->text + dialog->length, room);
    if (got > 0)
        dialog->length += (size_t)got;
    if (got != 0) /* more may come */
        return NULL;
    pclose(dialog->answer);
    dialog->answer = NULL;
    dialog->text[dialog->length] = '\0';
    dialog->text[strcspn(dialog->text, "\n")] = '\0';
    return *dialog->text ? mem_strdup(dialog->text) : NULL;
}

/* The folder of a file, or the working folder. */
static char *folder_beside(const char *file) {
    char *copy = mem_strdup(file), *slash = strrchr(copy, '/');
    if (slash)
        slash[slash == copy] = '\0';
    char *folder = realpath(slash ? copy : ".", NULL);
    free(copy);
    return folder ? folder : realpath(".", NULL);
}

bool file_dialog_open(struct file_dialog *dialog, const char *beside) {
    if (dialog->answer)
        return true;
    char *folder = folder_beside(beside);
    bool ok = folder && ask_desktop(dialog, folder);
    free(folder);
    return ok || error_set("zenity and kdialog are missing: drop a file on the window, or type its "
                           "path under Scene");
}

void file_dialog_close(struct file_dialog *dialog) {
    if (dialog->answer)
        pclose(dialog->answer);
    dialog->answer = NULL;
}
