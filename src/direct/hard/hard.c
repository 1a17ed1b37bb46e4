/* Direct light with hard shadow maps [Dong 2009 §6].
 *
 * The lookup is that of other maps of depth (visibility/lookup.glsl), filtered over the four nearest
 * texels, so that the shadow's edge is a texel wide and not stepped. */
#include "base/memory.h"
#include "direct/direct.h"
#include "gl/framebuffer.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "passes/visibility/shadow_map.h"
#include "shared/lookup.h"

#include <stdlib.h>

struct hard_settings {
    int shadow_size;
    float shadow_bias;
};

static const struct option table[] = {
    {"shadow-size", 0, OPTION_INT, offsetof(struct hard_settings, shadow_size), 2048, 16, 16384,
     .help = "shadow map of a light, texels a side"},
    {"shadow-bias", 0, OPTION_FLOAT, offsetof(struct hard_settings, shadow_bias), 1.5, 0, 100,
     .help = "receiver offset along its normal, in shadow texels"},
    {NULL},
};

static const struct settings_part own_part = {"hard", "direct light with hard shadows", table,
                                              sizeof(struct hard_settings)};

struct hard {
    struct shadow_map_pass shadow_map;
    GLuint perspective_program, orthographic_program;
    struct target {
        struct texture light;
        GLuint framebuffer;
    } target;
    struct buffer lookups[LIGHT_MAP_KINDS];
};

static bool init_target(struct target *target, int width, int height) {
    *target = (struct target){0};
    return texture_init(&target->light, &(struct texture_desc){.label = "direct",
                                                               .format = GL_RGBA32F,
                                                               .width = width,
                                                               .height = height}) &&
           framebuffer_init(
               &target->framebuffer,
               &(struct framebuffer_desc){.label = "direct", .colors = {&target->light}});
}

static void free_target(struct target *target) {
    framebuffer_free(&target->framebuffer);
    texture_free(&target->light);
}

static void free_state(void *state) {
    struct hard *hard = state;
    if (hard) {
        shadow_map_pass_free(&hard->shadow_map);
        program_free(&hard->perspective_program);
        program_free(&hard->orthographic_program);
        free_target(&hard->target);
        for (int kind = 0; kind < LIGHT_MAP_KINDS; kind++)
            buffer_free(&hard->lookups[kind]);
    }
    free(hard);
}

static bool init_program(GLuint *program, int projection) {
    char *defines = mem_printf("PROJECTION %d;FILTER %d", projection, FILTER_PCF);
    bool ok = program_init(program, &(struct program_desc){.vertex = "fullscreen.vert",
                                                           .fragment = "direct/hard/hard.frag",
                                                           .defines = defines});
    free(defines);
    return ok;
}

static bool init_lookups(struct hard *hard, int size, float bias) {
    bool ok = true;
    for (int kind = 0; kind < LIGHT_MAP_KINDS; kind++) {
        struct lookup_params params = {.bias = bias, .map_size = (float)light_map_size(kind, size)};
        ok = ok && buffer_init(&hard->lookups[kind], "direct lookup", sizeof params, &params);
    }
    return ok;
}

static bool init(void **state, const struct direct_desc *desc) {
    const struct hard_settings *own = settings_of(desc->settings, &own_part);
    struct hard *hard = *state = mem_alloc(1, sizeof *hard);
    return shadow_map_pass_init(&hard->shadow_map,
                                &(struct shadow_map_desc){own->shadow_size, *desc->lights}) &&
           init_program(&hard->perspective_program, PROJECTION_PERSPECTIVE) &&
           init_program(&hard->orthographic_program, PROJECTION_ORTHOGRAPHIC) &&
           init_target(&hard->target, desc->width, desc->height) &&
           init_lookups(hard, own->shadow_size, own->shadow_bias);
}

static bool resize(void *state, int width, int height) {
    struct hard *hard = state;
    struct target target;
    if (!init_target(&target, width, height)) {
        free_target(&target);
        return false;
    }
    free_target(&hard->target);
    hard->target = target;
    return true;
}

static void render_lights(void *state, const struct frame *frame) {
    struct hard *hard = state;
    shadow_map_pass_render(&hard->shadow_map, frame);
}

/* Adds one light's; the first one's takes the place of what was there. */
static void draw_light(const struct hard *hard, const struct frame *frame,
                       const struct gbuffer *gbuffer, int index) {
    const struct light *light = &frame->light_block->sources[index];
    int kind = frame->light_block->views[light->first_view].kind;
    bool directional = light->type == LIGHT_TYPE_DIRECTIONAL;
    GLuint program = directional ? hard->orthographic_program : hard->perspective_program;
    pass_set_state(&(struct pass_state){
        .name = "direct",
        .program = program,
        .framebuffer = hard->target.framebuffer,
        .width = hard->target.light.desc.width,
        .height = hard->target.light.desc.height,
        .blend = index > 0 ? PASS_BLEND_ADD : PASS_BLEND_OFF,
        .textures = {{UNIT_GBUFFER_DEPTH, gbuffer->depth.id},
                     {UNIT_GBUFFER_NORMAL, gbuffer->normal.id},
                     {UNIT_MAP_DEPTH, hard->shadow_map.maps[kind].id}},
        .blocks = {{BLOCK_VIEW, frame->view},
                   {BLOCK_LIGHTS, frame->lights},
                   {BLOCK_LOOKUP, &hard->lookups[kind]}},
    });
    gl.ProgramUniform1i(program, LOCATION_LIGHT, index);
    pass_draw_fullscreen(1);
}

static void render_view(void *state, const struct frame *frame, const struct gbuffer *gbuffer) {
    struct hard *hard = state;
    timer_begin(frame->timers, "direct");
    for (int i = 0; i < frame->light_block->count; i++)
        draw_light(hard, frame, gbuffer, i);
    timer_end(frame->timers);
}

static const struct texture *light(const void *state) {
    const struct hard *hard = state;
    return &hard->target.light;
}

static const struct settings_part *const parts[] = {&own_part, NULL};

extern const struct direct_method hard_direct;
const struct direct_method hard_direct = {
    .name = "hard",
    .help = "a shadow map for each light, hard shadows",
    .parts = parts,
    .init = init,
    .free = free_state,
    .resize = resize,
    .render_lights = render_lights,
    .render_view = render_view,
    .light = light,
};
