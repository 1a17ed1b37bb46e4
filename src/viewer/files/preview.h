/* A coarse picture of a scene that has been read, traced on a thread: it is there long before the
 * shaders are that render the scene. */
#ifndef VIEWER_PREVIEW_H
#define VIEWER_PREVIEW_H

#include "gl/texture.h"
#include "reference/path_tracer.h"

#include <pthread.h>
#include <stdatomic.h>

struct preview_desc {
    const struct scene *scene; /* must stay as they are until preview_stop */
    const struct geometry *geometry;
    struct camera camera;
    struct emitters emitters; /* the preview takes a copy */
    int width, height;        /* of the picture that it stands for */
    float exposure;           /* EV */
    bool auto_exposure;       /* by what the picture shows instead */
    void (*wake)(void);       /* called on the thread when there is a picture */
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

/* In place of what it has. */
void preview_start(struct preview *preview, const struct preview_desc *desc);

/* Whether preview_picture has something to do. */
bool preview_has_news(struct preview *preview);

/* The newest picture; NULL = none yet. */
const struct texture *preview_picture(struct preview *preview);

/* Ends the tracing; the picture stays. */
void preview_stop(struct preview *preview);

/* Accepts zeroed ones. */
void preview_free(struct preview *preview);

#endif
