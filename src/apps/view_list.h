/* Views of a file, --cameras: a line each, with the text of --camera, which may begin with a time.
 *
 *     # comments and empty lines do not count
 *     0 eye=0,1,3 forward=0,0,-1
 *     time=.5 intrinsics=300,300,160,120,320,240 opencv=1,0,0,0,0,-1,0,1,0,0,-1,3,0,0,0,1 */
#ifndef APPS_VIEW_LIST_H
#define APPS_VIEW_LIST_H

#include "scene/scene.h"

struct view_list {
    char *text; /* owned; the lines are in it */
    struct view_line {
        const char *camera;
        double time; /* seconds */
        int line;
    } * items;
    int count;
    char all[32]; /* their numbers, as --frames has them: */
};

/* Reads a file. Error: no file, an invalid time, no view. */
bool view_list_read(struct view_list *views, const char *path);
void view_list_free(struct view_list *views);

/* Checks all cameras. Error: names path and line of the first that the scene refuses. */
bool view_list_check(const struct view_list *views, const struct scene *scene, const char *path);

#endif
