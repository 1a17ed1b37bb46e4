/* Loads scenes on a thread of its own, so that the window reacts while a large file is read. */
#ifndef VIEWER_LOADER_H
#define VIEWER_LOADER_H

#include "scene/open.h"

#include <pthread.h>
#include <stdatomic.h>

/* A scene and its triangles */
struct document {
    struct scene scene;
    struct geometry geometry;
};

/* Frees scene and triangles. Accepts a zeroed document. */
void document_free(struct document *document);

enum loader_state { LOADER_IDLE, LOADER_BUSY, LOADER_DONE, LOADER_FAILED };

struct loader {
    pthread_t thread;
    atomic_int state; /* enum loader_state */
    char *path;
    struct scene_open_desc desc;
    char *next;        /* path of the next scene to load; NULL: none */
    bool is_abandoned; /* drop the scene that is being loaded */
    struct document document;
    char message[512];
};

/* Loads a scene. If another one is being loaded, queues this one in place of an earlier queued
 * one. desc (NULL: defaults) says how to open it; its texts must outlive the load. */
void loader_start(struct loader *loader, const char *path, const struct scene_open_desc *desc);

/* Returns the state. LOADER_DONE: the caller owns *document. LOADER_FAILED: sets the error. Both
 * are returned once. */
enum loader_state loader_poll(struct loader *loader, struct document *document);

/* Drops the scene that is being loaded and the queued one. */
void loader_abandon(struct loader *loader);

/* Returns true if a wanted scene is being loaded or queued. */
bool loader_is_busy(struct loader *loader);

/* Waits for the thread and frees everything. Accepts a zeroed loader. */
void loader_free(struct loader *loader);

#endif
