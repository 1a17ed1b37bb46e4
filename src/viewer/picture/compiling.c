#include "viewer/picture/compiling.h"

#include "base/log.h"
#include "scene/hash.h"

#include <string.h>

enum compiling_state { COMPILING_NONE, COMPILING_RUNS, COMPILING_DONE };

/* --- what a picture's programs depend on, or what they are drawn for --- */

static void add_light(uint64_t *sum, const struct emitter *light) {
    const int kind[] = {(int)light->type, (int)emitter_shape(light), light->lamp, light->stands_in};
    hash_bytes(sum, kind, sizeof kind);
}

/* Settings of the display are none of it. */
static uint64_t sum_of(const struct renderer_desc *desc) {
    const bool progressive = desc->progressive, sky = desc->emitters.sky;
    uint64_t sum = 0;
    hash_bytes(&sum, desc->scene->path, strlen(desc->scene->path));
    hash_bytes(&sum, &desc->technique, sizeof desc->technique);
    hash_bytes(&sum, &desc->direct, sizeof desc->direct);
    for (struct setting s = {0}; settings_next(&desc->settings, &s);) {
        double value = setting_number(&s, &desc->settings);
        if (!setting_is_among(&s, "picture.exposure picture.tone-map"))
            hash_bytes(&sum, &value, sizeof value);
    }
    hash_bytes(&sum, &progressive, sizeof progressive);
    hash_bytes(&sum, &sky, sizeof sky);
    for (int i = 0; i < desc->emitters.count; i++)
        add_light(&sum, &desc->emitters.items[i]);
    return sum;
}

static bool is_known(const struct compiling *compiling, uint64_t sum) {
    for (int i = 0; i < compiling->known_count; i++)
        if (compiling->known[i] == sum)
            return true;
    return false;
}

static void note_known(struct compiling *compiling) {
    if (compiling->known_count == COMPILING_KNOWN) {
        compiling->known_count--;
        memmove(compiling->known, compiling->known + 1,
                sizeof *compiling->known * (COMPILING_KNOWN - 1));
    }
    compiling->known[compiling->known_count++] = compiling->sum;
}

/* --- on the thread --- */

/* As it is at rest, while it moves, and as it accumulates passes. Failures are reported when the
 * window's own fails. */
static void draw(const struct renderer_desc *desc) {
    struct renderer renderer;
    if (!renderer_init(&renderer, desc))
        return;
    bool ok = renderer_update(&renderer);
    if (ok)
        renderer_render(&renderer);
    for (int pass = 0; ok && desc->progressive && pass < 2; pass++)
        renderer_add_pass(&renderer, pass);
    struct renderer_desc rough = renderer.desc;
    renderer_settings_roughen(&rough.settings);
    if (ok && renderer_follow(&renderer, &rough) && renderer_update(&renderer))
        renderer_render(&renderer);
    gl.Finish();
    renderer_free(&renderer);
}

static void *run(void *user) {
    struct compiling *compiling = user;
    log_tell_of_thread(false);
    window_bind(compiling->window);
    if (compiling->context)
        context_make_current(compiling->context);
    else
        compiling->context = context_adopt(window_getproc, false);
    if (compiling->context)
        context_set_store(compiling->context, compiling->store, true);
    if (compiling->context)
        draw(&compiling->desc);
    context_make_current(NULL);
    window_unbind();
    atomic_store(&compiling->state, COMPILING_DONE);
    compiling->wake();
    return NULL;
}

/* --- beginning and end --- */

static bool has_window(struct compiling *compiling) {
    if (!compiling->window && !compiling->refused) {
        compiling->window = window_create_hidden();
        compiling->refused = !compiling->window;
        compiling->store = program_store_create();
        context_set_store(compiling->user, compiling->store, false);
    }
    return compiling->window;
}

/* A side of the stand-in's picture: the small one leaves what the large one leaves where it is
 * parted into squares, and is a power of two where that is, which is compiled in. */
static int small_side(int side) {
    enum { SMALL = 192, PARTED = 64, POWER = 256 };
    if (side <= POWER)
        return side;
    return (side & (side - 1)) == 0 ? POWER : SMALL + side % PARTED;
}

static bool start(struct compiling *compiling, const struct renderer_desc *desc) {
    stand_in_init(&compiling->stand_in, desc->scene, desc->geometry);
    compiling->desc = *desc;
    compiling->desc.scene = &compiling->stand_in.scene;
    compiling->desc.geometry = &compiling->stand_in.geometry;
    compiling->desc.emitters = emitters_copy(&desc->emitters);
    if (desc->emitters.sky)
        compiling->desc.emitters.sky = compiling->stand_in.scene.environment;
    compiling->desc.timed = false;
    compiling->desc.width = small_side(desc->width);
    compiling->desc.height = small_side(desc->height);
    compiling->count_before = program_store_count(compiling->store);
    compiling->sum = sum_of(desc);
    atomic_store(&compiling->state, COMPILING_RUNS);
    if (pthread_create(&compiling->thread, NULL, run, compiling) == 0)
        return true;
    atomic_store(&compiling->state, COMPILING_NONE);
    stand_in_free(&compiling->stand_in);
    emitters_free(&compiling->desc.emitters);
    return false;
}

static void finish(struct compiling *compiling) {
    pthread_join(compiling->thread, NULL);
    atomic_store(&compiling->state, COMPILING_NONE);
    stand_in_free(&compiling->stand_in);
    emitters_free(&compiling->desc.emitters);
    compiling->refused |= !compiling->context;
    note_known(compiling);
}

void compiling_init(struct compiling *compiling, struct context *user, void (*wake)(void)) {
    *compiling = (struct compiling){.user = user, .wake = wake};
}

bool compiling_has_news(struct compiling *compiling) {
    return atomic_load(&compiling->state) == COMPILING_DONE;
}

bool compiling_has(struct compiling *compiling, const struct renderer_desc *desc) {
    if (compiling_has_news(compiling))
        finish(compiling);
    if (is_known(compiling, sum_of(desc)) || !has_window(compiling) || compiling->refused)
        return true;
    return atomic_load(&compiling->state) == COMPILING_NONE && !start(compiling, desc);
}

bool compiling_rests(struct compiling *compiling) {
    if (compiling_has_news(compiling))
        finish(compiling);
    return atomic_load(&compiling->state) == COMPILING_NONE;
}

int compiling_count(const struct compiling *compiling) {
    return program_store_count(compiling->store) - compiling->count_before;
}

void compiling_wait(struct compiling *compiling) {
    if (atomic_load(&compiling->state) != COMPILING_NONE)
        finish(compiling);
}

void compiling_free(struct compiling *compiling) {
    compiling_wait(compiling);
    if (compiling->user)
        context_set_store(compiling->user, NULL, false);
    context_free(compiling->context);
    program_store_free(compiling->store);
    window_free_hidden(compiling->window);
    *compiling = (struct compiling){0};
}
