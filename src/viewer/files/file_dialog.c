#define _GNU_SOURCE
#include "viewer/files/file_dialog.h"

#include "base/file/folder.h"
#include "base/memory.h"
#include "base/shell.h"

#include <dirent.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <unistd.h>

/* --- the desktop's --- */

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
            free(quoted);
            free(command);
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

/* --- our own: what a folder holds --- */

static void forget_names(struct file_dialog *dialog) {
    for (int i = 0; i < dialog->count; i++)
        free(dialog->names[i]);
    free(dialog->names);
    dialog->names = NULL;
    dialog->count = 0;
    dialog->chosen = -1;
}

static bool is_readable_here(const char *name) {
    static const char *const endings[] = {".gltf", ".glb", ".hdr", ".exr", ".settings"};
    size_t length = strlen(name);
    for (size_t i = 0; i < sizeof endings / sizeof *endings; i++) {
        size_t end = strlen(endings[i]);
        if (length > end && strcasecmp(name + length - end, endings[i]) == 0)
            return true;
    }
    return false;
}

static bool is_folder(const char *path) {
    struct stat status;
    return stat(path, &status) == 0 && S_ISDIR(status.st_mode);
}

static char *path_in(const struct file_dialog *dialog, const char *name) {
    return mem_printf("%s/%s", dialog->folder, name);
}

static void add(struct file_dialog *dialog, const char *name, bool folder) {
    dialog->names = mem_resize(dialog->names, (size_t)dialog->count + 1, sizeof *dialog->names);
    dialog->names[dialog->count++] = mem_printf("%s%s", name, folder ? "/" : "");
}

/* Hidden ones are left out. Chosen is the first but the folder above. */
static void list(struct file_dialog *dialog) {
    struct dirent **entries = NULL;
    forget_names(dialog);
    add(dialog, "..", true);
    int count = scandir(dialog->folder, &entries, NULL, alphasort);
    for (int folders = 1; folders >= 0; folders--)
        for (int i = 0; i < count; i++) {
            const char *name = entries[i]->d_name;
            char *path = path_in(dialog, name);
            bool folder = is_folder(path);
            if (*name != '.' && folder == (folders == 1) && (folder || is_readable_here(name)))
                add(dialog, name, folder);
            free(path);
        }
    for (int i = 0; i < count; i++)
        free(entries[i]);
    free(entries);
    dialog->chosen = dialog->count > 1 ? 1 : 0;
    dialog->seeks = true;
}

/* --- our own: where it goes --- */

/* The folder, and none of what was typed. */
static void go(struct file_dialog *dialog, char *folder) {
    free(dialog->folder);
    dialog->folder = folder;
    dialog->typed[0] = dialog->problem[0] = '\0';
    dialog->was_moved = false;
    list(dialog);
}

static void choose_name(struct file_dialog *dialog, const char *name) {
    for (int i = 0; i < dialog->count; i++)
        if (strcmp(dialog->names[i], name) == 0)
            dialog->chosen = i;
}

/* A folder is entered (NULL), a file ends the dialog; path is freed, and may be NULL. */
static char *take(struct file_dialog *dialog, char *path) {
    char *whole = path ? realpath(path, NULL) : NULL;
    free(path);
    if (!whole)
        return NULL;
    if (is_folder(whole)) {
        go(dialog, whole);
        return NULL;
    }
    file_dialog_close(dialog);
    return whole;
}

char *file_dialog_choose(struct file_dialog *dialog, int n) {
    if (strcmp(dialog->names[n], "../") != 0)
        return take(dialog, path_in(dialog, dialog->names[n]));
    file_dialog_leave(dialog);
    return NULL;
}

void file_dialog_search(struct file_dialog *dialog) {
    size_t length = strlen(dialog->typed);
    dialog->was_moved = false;
    dialog->problem[0] = '\0';
    for (int i = length > 0 ? 0 : dialog->count; i < dialog->count; i++)
        if (strncasecmp(dialog->names[i], dialog->typed, length) == 0) {
            dialog->chosen = i;
            dialog->seeks = true;
            return;
        }
}

void file_dialog_move(struct file_dialog *dialog, int by) {
    int to = dialog->chosen + by;
    dialog->chosen = to < 0 ? 0 : to >= dialog->count ? dialog->count - 1 : to;
    dialog->seeks = dialog->was_moved = true;
}

void file_dialog_enter(struct file_dialog *dialog, const char *folder) {
    char *file = take(dialog, path_of_user(folder));
    free(file);
}

/* The folder that was left is chosen, to be entered again. */
void file_dialog_leave(struct file_dialog *dialog) {
    char *left = mem_printf("%s/", path_name(dialog->folder));
    take(dialog, path_in(dialog, ".."));
    choose_name(dialog, left);
    free(left);
}

/* What was typed as a whole path. */
static char *typed_path(const struct file_dialog *dialog) {
    bool is_whole = dialog->typed[0] == '/' || dialog->typed[0] == '~';
    return is_whole ? path_of_user(dialog->typed) : path_in(dialog, dialog->typed);
}

/* Whether the name that is chosen begins as what was typed. */
static bool is_found(const struct file_dialog *dialog) {
    return dialog->chosen >= 0 &&
           strncasecmp(dialog->names[dialog->chosen], dialog->typed, strlen(dialog->typed)) == 0;
}

char *file_dialog_accept(struct file_dialog *dialog) {
    if (*dialog->typed && !dialog->was_moved) {
        char *path = typed_path(dialog);
        if (access(path, F_OK) == 0)
            return take(dialog, path);
        free(path);
        if (!is_found(dialog)) {
            snprintf(dialog->problem, sizeof dialog->problem,
                     "There is no file or folder '%.200s'.", dialog->typed);
            return NULL;
        }
    }
    return dialog->chosen >= 0 ? file_dialog_choose(dialog, dialog->chosen) : NULL;
}

/* --- both --- */

/* The folder of a file, or the working folder. */
static char *folder_beside(const char *file) {
    char *copy = mem_strdup(file ? file : "."), *slash = strrchr(copy, '/');
    if (slash)
        slash[slash == copy] = '\0';
    char *folder = realpath(slash ? copy : ".", NULL);
    free(copy);
    return folder ? folder : realpath(".", NULL);
}

void file_dialog_open(struct file_dialog *dialog, const char *beside) {
    if (dialog->answer || dialog->is_open)
        return;
    char *folder = folder_beside(beside);
    if (!folder || ask_desktop(dialog, folder)) {
        free(folder);
        return;
    }
    dialog->is_open = true;
    go(dialog, folder);
    if (beside)
        choose_name(dialog, path_name(beside));
}

void file_dialog_close(struct file_dialog *dialog) {
    forget_names(dialog);
    free(dialog->folder);
    dialog->folder = NULL;
    dialog->is_open = false;
    if (dialog->answer)
        pclose(dialog->answer);
    dialog->answer = NULL;
}
