/* The pictures of a folder that are named SCENE.WxH.exr or, of one frame of a clip,
 * SCENE.WxH.FRAME.exr. */
#ifndef LAB_SCORE_ENTRY_H
#define LAB_SCORE_ENTRY_H

#include <stdbool.h>

enum { NO_FRAME = -1 };

struct entry_picture {
    char *file; /* its name in the folder */
    char *scene;
    int width, height, frame; /* NO_FRAME: none is told */
};

struct entry {
    struct entry_picture *pictures; /* in the order of the files' names */
    int count;
    char **others; /* EXR files that are named otherwise */
    int other_count;
};

/* Error: the folder cannot be read. */
bool entry_list(struct entry *entry, const char *folder);
void entry_free(struct entry *entry);

/* The picture of that file's name; NULL: there is none. */
const struct entry_picture *entry_find(const struct entry *entry, const char *file);

#endif
