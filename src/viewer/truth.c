#include "viewer/truth.h"

#include "base/error.h"
#include "base/memory.h"
#include "base/parallel.h"
#include "measure/picture.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* --- on the thread --- */

/* From any of the tracer's threads. */
static bool go_on(void *user, const struct path_tracer_progress *progress) {
    struct truth *truth = user;
    (void)progress;
    pthread_mutex_lock(&truth->lock);
    while (truth->paused && !atomic_load(&truth->cancelled))
        pthread_cond_wait(&truth->resumed, &truth->lock);
    pthread_mutex_unlock(&truth->lock);
    return !atomic_load(&truth->cancelled);
}

static struct image copy_of(const struct image *image) {
    struct image copy = {0};
    image_init_named(&copy, image->width, image->height, (const char *const *)image->names,
                     image->channel_count);
    memcpy(copy.pixels, image->pixels,
           sizeof *image->pixels * (size_t)image->width * (size_t)image->height *
               (size_t)image->channel_count);
    return copy;
}

/* The picture is the truth's from now on. */
static void put(struct truth *truth, struct image *picture,
                const struct path_tracer_progress *reached) {
    pthread_mutex_lock(&truth->lock);
    image_free(&truth->newest.image);
    truth->newest = (struct truth_picture){*picture, reached->samples, reached->noise};
    pthread_mutex_unlock(&truth->lock);
    truth->wake();
}

static void show(void *user, const struct image *image,
                 const struct path_tracer_progress *reached) {
    struct image copy = copy_of(image);
    put(user, &copy, reached);
}

/* The window comes first. */
static int spare_threads(void) {
    int cores = parallel_core_count();
    return cores > 1 ? cores - 1 : 1;
}

static bool trace_stage(struct truth *truth, const struct stage *stage) {
    struct path_tracer_progress reached;
    struct image picture;
    const struct path_tracer_desc desc = {
        .width = truth->width,
        .height = truth->height,
        .bounces = truth->bounces,
        .paths = 1, /* the first picture is to come soon */
        .noise = truth->noise,
        .threads = spare_threads(),
        .progress = go_on,
        .show = show,
        .user = truth,
    };
    if (!picture_trace_paths(stage, &desc, &picture, &reached))
        return false;
    put(truth, &picture, &reached);
    return true;
}

static bool trace(struct truth *truth) {
    struct stage stage;
    struct stage_desc desc = {
        .path = truth->scene,
        .camera = truth->camera,
        .light = truth->lights,
        .environment = {truth->environment, truth->turn, truth->strength},
        .time = truth->time,
    };
    desc.clip = *truth->clip ? truth->clip : NULL;
    if (!stage_init(&stage, &desc))
        return false;
    bool ok = trace_stage(truth, &stage);
    stage_free(&stage);
    return ok;
}

static void *run(void *context) {
    struct truth *truth = context;
    bool ok = trace(truth);
    if (!ok)
        snprintf(truth->message, sizeof truth->message, "%s", error_get());
    atomic_store(&truth->state, ok ? TRUTH_DONE : TRUTH_FAILED);
    truth->wake();
    return NULL;
}

/* --- outside --- */

static void tell_view(struct truth *truth, const struct truth_view *view) {
    const struct session *session = view->session;
    *truth = (struct truth){
        .scene = mem_strdup(session->scene),
        .camera = mem_strdup(session->camera),
        .lights = mem_strdup(session->lights),
        .time = session->time,
        .width = session->width,
        .height = session->height,
        .bounces = view->bounces,
        .noise = view->noise,
        .wake = view->wake,
    };
    memcpy(truth->clip, session->clip, sizeof truth->clip);
    if (session->sky) {
        truth->environment = mem_strdup(session->sky);
        truth->turn = session->sky_turn;
        truth->strength = session->sky_strength;
    }
}

static void forget(struct truth *truth) {
    pthread_mutex_destroy(&truth->lock);
    pthread_cond_destroy(&truth->resumed);
    image_free(&truth->newest.image);
    free(truth->scene);
    free(truth->camera);
    free(truth->lights);
    free(truth->environment);
    *truth = (struct truth){0};
}

bool truth_start(struct truth *truth, const struct truth_view *view) {
    truth_stop(truth);
    tell_view(truth, view);
    pthread_mutex_init(&truth->lock, NULL);
    pthread_cond_init(&truth->resumed, NULL);
    atomic_store(&truth->state, TRUTH_TRACING);
    if (pthread_create(&truth->thread, NULL, run, truth) == 0)
        return true;
    forget(truth);
    return error_set("no thread can be started to trace the reference");
}

void truth_stop(struct truth *truth) {
    if (atomic_load(&truth->state) == TRUTH_NONE)
        return;
    atomic_store(&truth->cancelled, true);
    truth_pause(truth, false);
    pthread_join(truth->thread, NULL);
    forget(truth);
}

void truth_pause(struct truth *truth, bool paused) {
    if (atomic_load(&truth->state) == TRUTH_NONE)
        return;
    pthread_mutex_lock(&truth->lock);
    truth->paused = paused;
    pthread_cond_broadcast(&truth->resumed);
    pthread_mutex_unlock(&truth->lock);
}

bool truth_has_news(struct truth *truth) {
    enum truth_state state = (enum truth_state)atomic_load(&truth->state);
    if (state != TRUTH_TRACING)
        return state != TRUTH_NONE;
    pthread_mutex_lock(&truth->lock);
    bool news = truth->newest.image.pixels;
    pthread_mutex_unlock(&truth->lock);
    return news;
}

enum truth_state truth_poll(struct truth *truth, struct truth_picture *newest) {
    enum truth_state state = (enum truth_state)atomic_load(&truth->state);
    *newest = (struct truth_picture){0};
    if (state == TRUTH_NONE)
        return state;
    pthread_mutex_lock(&truth->lock);
    *newest = truth->newest;
    truth->newest.image = (struct image){0};
    pthread_mutex_unlock(&truth->lock);
    if (state == TRUTH_TRACING)
        return state;
    if (state == TRUTH_FAILED)
        error_set("%s", truth->message);
    pthread_join(truth->thread, NULL);
    forget(truth);
    return state;
}
