/* Shows scenes as small pictures to click. A thread traces each once and keeps it in the user's
 * cache. */
#ifndef VIEWER_GALLERY_H
#define VIEWER_GALLERY_H

#include "gl/texture.h"

#include <pthread.h>
#include <stdatomic.h>

enum { GALLERY_MAX = 40, GALLERY_WIDTH = 192, GALLERY_HEIGHT = 144 };

struct gallery_item {
    char *path, *picture; /* files of the scene and of its picture, which may not exist yet */
    atomic_int ready;     /* 1: the picture exists; -1: there is none, or it has one colour */
    struct texture texture;
    bool has_texture;
};

/* Zeroed: empty. */
struct gallery {
    struct gallery_item items[GALLERY_MAX];
    int count;
    pthread_t thread;
    bool has_thread;
    atomic_bool cancelled;
    void (*wake)(void); /* called on the thread if there is news */
};

/* Adds the scenes of the program's installation. */
void gallery_add_own(struct gallery *gallery);

/* Starts a thread that makes the missing pictures. */
void gallery_start(struct gallery *gallery, void (*wake)(void));

/* Uploads new pictures to textures. */
void gallery_follow(struct gallery *gallery);

/* Returns true if gallery_follow has work to do. */
bool gallery_has_news(struct gallery *gallery);

/* Ends the thread and frees everything. Accepts a zeroed gallery. */
void gallery_free(struct gallery *gallery);

#endif
