#include "viewer/reference/reference_tracer.h"

#include "base/error.h"
#include "base/memory.h"
#include "base/parallel.h"
#include "quality/picture.h"
#include "scene/caustics.h"
#include "scene/material.h"
#include "scene/medium.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* --- on the thread --- */

/* From any of the tracer's threads. */
static bool go_on(void *user, const struct path_tracer_progress *progress) {
    struct reference_tracer *tracer = user;
    (void)progress;
    pthread_mutex_lock(&tracer->lock);
    while (tracer->paused && !atomic_load(&tracer->cancelled))
        pthread_cond_wait(&tracer->resumed, &tracer->lock);
    pthread_mutex_unlock(&tracer->lock);
    return !atomic_load(&tracer->cancelled);
}

/* The picture is the tracer's from now on. */
static void put(struct reference_tracer *tracer, struct image *picture,
                const struct path_tracer_progress *reached) {
    pthread_mutex_lock(&tracer->lock);
    image_free(&tracer->newest.image);
    tracer->newest = (struct traced_picture){*picture, reached->samples, reached->noise};
    pthread_mutex_unlock(&tracer->lock);
    tracer->wake();
}

static void show(void *user, const struct image *image,
                 const struct path_tracer_progress *reached) {
    struct image copy = image_copy(image);
    put(user, &copy, reached);
}

/* The window comes first. */
static int spare_threads(void) {
    int cores = parallel_core_count();
    return cores > 1 ? cores - 1 : 1;
}

static bool trace_stage(struct reference_tracer *tracer, const struct stage *stage) {
    struct path_tracer_progress reached;
    struct image picture;
    const struct material_settings *surface =
        settings_of(struct material_settings, &tracer->session.settings, &material_part);
    const struct path_tracer_desc desc = {
        .width = tracer->session.width,
        .height = tracer->session.height,
        .bounces = tracer->bounces,
        .materials = surface->materials,
        .medium = medium_of(&stage->scene, &tracer->session.settings, stage->geometry.radius),
        .smooth = caustics_shown(&stage->scene, &tracer->session.settings),
        .paths = 1, /* the first picture is to come soon */
        .noise = tracer->noise,
        .threads = spare_threads(),
        .progress = go_on,
        .show = show,
        .user = tracer,
    };
    if (!picture_trace_paths(stage, &desc, &picture, &reached))
        return false;
    put(tracer, &picture, &reached);
    return true;
}

static bool trace(struct reference_tracer *tracer) {
    struct stage stage;
    const struct session *session = &tracer->session;
    struct stage_desc desc = {
        .path = tracer->scene,
        .choice = {session->shown_scene, session->variant},
        .camera = session->camera,
        .light = session->lights,
        .clip = *session->clip ? session->clip : NULL,
        .time = session->time,
        .punctual_scale = tracer->punctual_scale,
    };
    if (session->sky)
        desc.environment =
            (struct environment_desc){session->sky, session->sky_turn, session->sky_strength};
    if (!stage_init(&stage, &desc))
        return false;
    bool ok = trace_stage(tracer, &stage);
    stage_free(&stage);
    return ok;
}

static void *run(void *context) {
    struct reference_tracer *tracer = context;
    bool ok = trace(tracer);
    if (!ok)
        snprintf(tracer->message, sizeof tracer->message, "%s", error_get());
    atomic_store(&tracer->state, ok ? TRACER_DONE : TRACER_FAILED);
    tracer->wake();
    return NULL;
}

/* --- outside --- */

static void forget(struct reference_tracer *tracer) {
    pthread_mutex_destroy(&tracer->lock);
    pthread_cond_destroy(&tracer->resumed);
    image_free(&tracer->newest.image);
    free(tracer->scene);
    session_free(&tracer->session);
    *tracer = (struct reference_tracer){0};
}

bool reference_tracer_start(struct reference_tracer *tracer, const struct traced_view *view) {
    reference_tracer_stop(tracer);
    *tracer = (struct reference_tracer){
        .scene = mem_strdup(view->session->scene),
        .session = session_copy(view->session),
        .punctual_scale = view->punctual_scale,
        .bounces = view->bounces,
        .noise = view->noise,
        .wake = view->wake,
    };
    pthread_mutex_init(&tracer->lock, NULL);
    pthread_cond_init(&tracer->resumed, NULL);
    atomic_store(&tracer->state, TRACER_TRACING);
    if (pthread_create(&tracer->thread, NULL, run, tracer) == 0)
        return true;
    forget(tracer);
    return error_set("no thread can be started to trace the reference");
}

void reference_tracer_stop(struct reference_tracer *tracer) {
    if (atomic_load(&tracer->state) == TRACER_NONE)
        return;
    atomic_store(&tracer->cancelled, true);
    reference_tracer_pause(tracer, false);
    pthread_join(tracer->thread, NULL);
    forget(tracer);
}

void reference_tracer_pause(struct reference_tracer *tracer, bool paused) {
    if (atomic_load(&tracer->state) == TRACER_NONE)
        return;
    pthread_mutex_lock(&tracer->lock);
    tracer->paused = paused;
    pthread_cond_broadcast(&tracer->resumed);
    pthread_mutex_unlock(&tracer->lock);
}

bool reference_tracer_has_news(struct reference_tracer *tracer) {
    enum reference_tracer_state state = (enum reference_tracer_state)atomic_load(&tracer->state);
    if (state != TRACER_TRACING)
        return state != TRACER_NONE;
    pthread_mutex_lock(&tracer->lock);
    bool news = tracer->newest.image.pixels;
    pthread_mutex_unlock(&tracer->lock);
    return news;
}

enum reference_tracer_state reference_tracer_poll(struct reference_tracer *tracer,
                                                  struct traced_picture *newest) {
    enum reference_tracer_state state = (enum reference_tracer_state)atomic_load(&tracer->state);
    *newest = (struct traced_picture){0};
    if (state == TRACER_NONE)
        return state;
    pthread_mutex_lock(&tracer->lock);
    *newest = tracer->newest;
    tracer->newest.image = (struct image){0};
    pthread_mutex_unlock(&tracer->lock);
    if (state == TRACER_TRACING)
        return state;
    if (state == TRACER_FAILED)
        error_set("%s", tracer->message);
    pthread_join(tracer->thread, NULL);
    forget(tracer);
    return state;
}
