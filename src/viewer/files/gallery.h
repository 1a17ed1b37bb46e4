/* Scenes as pictures to click: small ones, traced on a thread once and kept in the user's cache. */
#ifndef VIEWER_GALLERY_H
#define VIEWER_GALLERY_H

#include "gl/texture.h"

#include <pthread.h>
#include <stdatomic.h>

enum { GALLERY_MAX = 40, GALLERY_WIDTH = 192, GALLERY_HEIGHT = 144 };

struct gallery_item {
    char *path, *picture; /* the scene's file; its picture's, which may not be there yet */
    atomic_int
        ready; /* by the thread: the picture is there, or (-1) none can be made, or is worth it */
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
    void (*wake)(void); /* called on the thread when there is something new */
};

/* Adds the scenes that come with the program, where they are found. */
void gallery_add_own(struct gallery *gallery);

/* Begins to make the pictures that are missing. */
void gallery_start(struct gallery *gallery, void (*wake)(void));

/* Takes pictures that have been made into textures. */
void gallery_follow(struct gallery *gallery);

/* Whether gallery_follow has something to do. */
bool gallery_has_news(struct gallery *gallery);

/* Ends the thread and frees all. Accepts zeroed ones. */
void gallery_free(struct gallery *gallery);

#endif
