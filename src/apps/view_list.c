#define _POSIX_C_SOURCE 200809L
#include "apps/view_list.h"

#include "base/error.h"
#include "base/file/file.h"
#include "base/memory.h"
#include "scene/placing.h"

#include <stdio.h>
#include <string.h>

static bool add_line(struct view_list *views, char *line, int number) {
    struct view_line view = {.camera = line, .line = number};
    if (strncmp(line, "time=", 5) == 0) {
        char *end;
        view.time = (double)strtof(line + 5, &end); /* rounded as --time is: the same bits */
        if (end == line + 5 || !(view.time >= 0 && view.time <= 1e6) || (*end && *end != ' '))
            return error_set("line %d: '%.20s' wants seconds, as in time=.5", number, line);
        view.camera = end + strspn(end, " ");
    }
    views->items = mem_resize(views->items, (size_t)views->count + 1, sizeof *views->items);
    views->items[views->count++] = view;
    return true;
}

bool view_list_read(struct view_list *views, const char *path) {
    *views = (struct view_list){.text = file_read_text(path)};
    if (!views->text)
        return false;
    bool ok = true;
    int number = 0;
    for (char *next = views->text; ok && *next;) {
        char *line = next + strspn(next, " ");
        next += strcspn(next, "\n");
        if (*next)
            *next++ = '\0';
        line[strcspn(line, "\r")] = '\0';
        number++;
        ok = *line == '\0' || *line == '#' || add_line(views, line, number);
    }
    snprintf(views->all, sizeof views->all, "0..%d", views->count - 1);
    ok = ok && (views->count > 0 || error_set("it has no view"));
    return ok || error_prefix("%s", path);
}

void view_list_free(struct view_list *views) {
    mem_free(views->text, views->items);
    *views = (struct view_list){.count = 0};
}

bool view_list_check(const struct view_list *views, const struct scene *scene, const char *path) {
    for (int i = 0; i < views->count; i++) {
        const struct view_line *view = &views->items[i];
        struct camera camera;
        if (!camera_from_text(&camera, scene, view->camera, view->time, NULL))
            return error_prefix("%s: line %d", path, view->line);
    }
    return true;
}
