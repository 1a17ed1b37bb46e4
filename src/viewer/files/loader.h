/* Loads scenes on a thread of its own, so that the window lives on while a large file is read. */
#ifndef VIEWER_LOADER_H
#define VIEWER_LOADER_H

#include "scene/open.h"

#include <pthread.h>
#include <stdatomic.h>

/* A scene and its triangles. */
struct document {
    struct scene scene;
    struct geometry geometry;
};

/* Accepts zeroed ones. */
void document_free(struct document *document);

enum loader_state { LOADER_IDLE, LOADER_BUSY, LOADER_DONE, LOADER_FAILED };

struct loader {
    pthread_t thread;
    atomic_int state; /* enum loader_state */
    char *path;
    struct scene_open_desc desc;
    char *next;        /* asked for meanwhile */
    bool is_abandoned; /* what is being loaded is not wanted any more */
    struct document document;
    char message[512];
};

/* While another one is being loaded, this one is next; of several the last. desc, unless NULL: how
 * it is opened; its texts must live on. */
void loader_start(struct loader *loader, const char *path, const struct scene_open_desc *desc);

/* LOADER_DONE: *document is the caller's. LOADER_FAILED: error_get tells. Both are returned once */
enum loader_state loader_poll(struct loader *loader, struct document *document);

/* What is being loaded is let go when it is there, and nothing is next. */
void loader_abandon(struct loader *loader);

/* Whether something that is wanted is being loaded, or is next. */
bool loader_is_busy(struct loader *loader);

/* Waits for what is being loaded. Accepts a zeroed one. */
void loader_free(struct loader *loader);

#endif
