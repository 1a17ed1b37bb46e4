#define _GNU_SOURCE
#include "viewer/file_dialog.h"

#include "base/memory.h"

#include <dirent.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* --- the desktop's --- */

static const char *const commands[][2] = {
    {"zenity", "zenity --file-selection --title='Open a scene' 2>/dev/null"},
    {"kdialog", "kdialog --getopenfilename . 2>/dev/null"},
};

static bool is_in_path(const char *name) {
    char *path = mem_strdup(getenv("PATH") ? getenv("PATH") : ""), *rest = NULL;
    bool found = false;
    for (char *folder = strtok_r(path, ":", &rest); folder && !found;
         folder = strtok_r(NULL, ":", &rest)) {
        char *program = mem_printf("%s/%s", folder, name);
        found = access(program, X_OK) == 0;
        free(program);
    }
    free(path);
    return found;
}

static bool ask_desktop(struct file_dialog *dialog) {
    for (size_t i = 0; i < sizeof commands / sizeof *commands; i++)
        if (is_in_path(commands[i][0])) {
            dialog->answer = popen(commands[i][1], "re");
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

/* --- our own --- */

static void forget_names(struct file_dialog *dialog) {
    for (int i = 0; i < dialog->count; i++)
        free(dialog->names[i]);
    dialog->count = 0;
}

static bool is_readable_here(const char *name) {
    static const char *const endings[] = {".gltf", ".glb", ".exr", ".settings"};
    size_t length = strlen(name);
    for (size_t i = 0; i < sizeof endings / sizeof *endings; i++) {
        size_t end = strlen(endings[i]);
        if (length > end && strcasecmp(name + length - end, endings[i]) == 0)
            return true;
    }
    return false;
}

static bool is_folder(const char *folder, const char *name) {
    struct stat status;
    char *path = mem_printf("%s/%s", folder, name);
    bool is = stat(path, &status) == 0 && S_ISDIR(status.st_mode);
    free(path);
    return is;
}

static void add(struct file_dialog *dialog, const char *name, bool folder) {
    if (dialog->count < FOLDER_ENTRIES_MAX)
        dialog->names[dialog->count++] = mem_printf("%s%s", name, folder ? "/" : "");
}

/* Hidden ones are left out. */
static void list(struct file_dialog *dialog) {
    struct dirent **entries = NULL;
    forget_names(dialog);
    add(dialog, "..", true);
    int count = scandir(dialog->folder, &entries, NULL, alphasort);
    for (int folders = 1; folders >= 0; folders--)
        for (int i = 0; i < count; i++) {
            const char *name = entries[i]->d_name;
            bool folder = is_folder(dialog->folder, name);
            if (*name != '.' && folder == (folders == 1) && (folder || is_readable_here(name)))
                add(dialog, name, folder);
        }
    for (int i = 0; i < count; i++)
        free(entries[i]);
    free(entries);
}

char *file_dialog_choose(struct file_dialog *dialog, int n) {
    const char *name = dialog->names[n];
    size_t length = strlen(name);
    bool folder = name[length - 1] == '/';
    char *path = mem_printf("%s/%.*s", dialog->folder, (int)(length - folder), name);
    char *whole = realpath(path, NULL);
    free(path);
    if (!whole)
        return NULL;
    if (!folder) {
        file_dialog_close(dialog);
        return whole;
    }
    free(dialog->folder);
    dialog->folder = whole;
    list(dialog);
    return NULL;
}

/* --- both --- */

void file_dialog_open(struct file_dialog *dialog) {
    if (file_dialog_is_open(dialog) || ask_desktop(dialog))
        return;
    dialog->folder = realpath(".", NULL);
    dialog->is_open = dialog->folder;
    if (dialog->is_open)
        list(dialog);
}

bool file_dialog_is_open(const struct file_dialog *dialog) {
    return dialog->answer || dialog->is_open;
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
