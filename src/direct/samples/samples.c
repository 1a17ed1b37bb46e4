/* Direct light of lights with a size, each as many without, spread over its shape: what all softer
 * methods are measured by. */
#include "base/halton.h"
#include "base/memory.h"
#include "direct/shadow.h"
#include "passes/frame.h"

#include <cglm/cglm.h>
#include <math.h>

#include <string.h>

struct samples_settings {
    int points;
};

static const struct option table[] = {
    {"points", 0, OPTION_INT, offsetof(struct samples_settings, points), 64, 1, 4096,
     .label = "light samples",
     .help = "light samples per light, one shadow map\n"
             "each; raise against steps in penumbrae"},
    {NULL},
};

static const struct settings_part own_part = {"samples", "direct light by light samples", table,
                                              sizeof(struct samples_settings)};

struct samples {
    struct shadow shadow;
    struct light_block *block; /* of one point of each light */
    struct buffer lights;      /* the same, for BLOCK_LIGHTS */
    struct emitters points;
    int count;
};

static void free_state(void *state) {
    struct samples *samples = state;
    if (samples) {
        shadow_end(&samples->shadow);
        buffer_free(&samples->lights);
        emitters_free(&samples->points);
        free(samples->block);
    }
    free(samples);
}

static bool init(void **state, const struct direct_desc *desc) {
    const struct samples_settings *own =
        settings_of(struct samples_settings, desc->settings, &own_part);
    struct samples *samples = *state = mem_alloc(1, sizeof *samples);
    samples->count = own->points;
    samples->block = mem_alloc(1, sizeof *samples->block);
    samples->points.items = mem_alloc(LIGHTS_MAX, sizeof *samples->points.items);
    return shadow_begin(&samples->shadow, desc,
                        &(struct direct_light_desc){.fragment = "passes/visibility/direct.frag",
                                                    .defines = ""}) &&
           buffer_init(&samples->lights, "points of lights", sizeof *samples->block, NULL);
}

/* The i-th point of each light, with its share of the light. The mean of all points is
 * the middle. */
static void take_points(struct samples *samples, const struct frame *frame, int i) {
    double half = .5 / samples->count, y = half + radical_inverse(2, (uint32_t)i);
    float place[2] = {((float)i + .5F) / (float)samples->count, (float)(y - floor(y))};
    samples->points.count = frame->emitters->count;
    for (int n = 0; n < samples->points.count; n++) {
        struct emitter *point = &samples->points.items[n];
        *point = emitter_piece(&frame->emitters->items[n], place);
        glm_vec3_scale(point->intensity, 1 / (float)samples->count, point->intensity);
    }
    views_of_emitters(samples->block, &samples->points, frame->geometry);
    buffer_write(&samples->lights, 0, sizeof *samples->block, samples->block);
}

static void render_view(void *state, const struct frame *frame, const struct gbuffer *gbuffer) {
    struct samples *samples = state;
    struct frame of_points = *frame;
    of_points.lights = &samples->lights;
    of_points.light_block = samples->block;
    of_points.emitters = &samples->points;
    for (int i = 0; i < samples->count; i++) {
        take_points(samples, frame, i);
        shadow_render_lights(samples, &of_points);
        direct_light_pass_render(&samples->shadow.light, &of_points, gbuffer,
                                 &samples->shadow.inputs,
                                 i > 0 ? DIRECT_LIGHT_ADDS : DIRECT_LIGHT_ANEW);
    }
}

static const struct settings_part *const parts[] = {&own_part, &shadow_part, NULL};

extern const struct direct_method samples_direct;
const struct direct_method samples_direct = {
    .name = "samples",
    .help = "the reference: shadow maps of many samples of each light, slow",
    .parts = parts,
    .init = init,
    .free = free_state,
    .render_view = render_view,
    SHADOW_METHOD,
};
