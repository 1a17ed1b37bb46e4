/* Traces a coarse picture of a scene on a thread, to show it before its shaders are compiled. */
#ifndef VIEWER_PREVIEW_H
#define VIEWER_PREVIEW_H

#include "gl/texture.h"
#include "reference/path_tracer.h"

#include <pthread.h>
#include <stdatomic.h>

struct preview_desc {
    const struct scene *scene; /* scene and geometry must not change until preview_stop */
    const struct geometry *geometry;
    struct camera camera;
    struct emitters emitters; /* copied */
    int width, height;        /* of the final picture, pixels */
    float exposure;           /* EV */
    bool auto_exposure;       /* chosen from the picture instead */
    void (*wake)(void);       /* called on the thread if there is a new picture */
};

/* Zeroed: none. */
struct preview {
    struct preview_desc desc;
    pthread_t thread;
    bool has_thread;
    atomic_bool cancelled, is_new;
    pthread_mutex_t lock;
    struct bitmap newest;
    struct texture texture;
    bool has_texture;
};

/* Starts to trace a picture, in place of the one before. */
void preview_start(struct preview *preview, const struct preview_desc *desc);

/* Returns true if preview_picture has work to do. */
bool preview_has_news(struct preview *preview);

/* Returns the newest picture, or NULL if there is none yet. */
const struct texture *preview_picture(struct preview *preview);

/* Ends the tracing and keeps the picture. */
void preview_stop(struct preview *preview);

/* Ends the tracing and frees everything. Accepts a zeroed preview. */
void preview_free(struct preview *preview);

#endif
