#include "passes/caustics/caustics.h"

#include "base/halton.h"
#include "base/memory.h"
#include "gl/framebuffer.h"
#include "gl/program.h"
#include "lights/light_samples.h"
#include "passes/frame.h"
#include "passes/targets.h"

#include <cglm/cglm.h>
#include <math.h>
#include <stdlib.h>

/* Surfaces that are nearer than this are one, over the scene's radius. */
static const float reach = .01F;

/* --- life ------------------------------------------------------------------------------------- */

/* Those of segments to a surface that scatters, and between two smooth surfaces. */
static bool init_line_programs(struct caustics_pass *pass) {
    struct program_desc desc = {.vertex = "passes/caustics/light_lines.vert",
                                .fragment = "passes/caustics/light_lines.frag"};
    bool published = pass->desc.published;
    desc.defines = published ? "HAS_MEDIUM;PUBLISHED 1" : "HAS_MEDIUM;PUBLISHED 0";
    if (!program_init(&pass->line_program, &desc))
        return false;
    desc.defines = published ? "HAS_MEDIUM;PUBLISHED 1;BETWEEN" : "HAS_MEDIUM;PUBLISHED 0;BETWEEN";
    return program_init(&pass->between_program, &desc);
}

static bool init_ray_program(struct caustics_pass *pass) {
    char *defines =
        mem_printf("%s%s", light_defines(pass->desc.medium, pass->desc.scene->slide_count > 0),
                   pass->desc.volume ? "HAS_LINES;" : "");
    bool ok = program_init(
        &pass->ray_program,
        &(struct program_desc){.screen = {"passes/caustics/light_rays.frag"}, .defines = defines});
    free(defines);
    return ok;
}

static bool init_programs(struct caustics_pass *pass) {
    const char *medium = pass->desc.medium ? "HAS_MEDIUM" : NULL;
    const struct program_desc patch = {.vertex = "passes/caustics/patch.vert",
                                       .fragment = "passes/caustics/patch.frag"};
    const struct program_desc splat = {.vertex = "passes/caustics/patch.vert",
                                       .fragment = "passes/caustics/patch.frag",
                                       .defines = "SPLATS"};
    bool ok = init_ray_program(pass);
    if (ok && pass->desc.surface)
        ok = program_init(&pass->cell_program,
                          &(struct program_desc){.screen = {"passes/caustics/ray_cells.frag"},
                                                 .defines = medium}) &&
             program_init(&pass->splat_list_program,
                          &(struct program_desc){.screen = {"passes/caustics/ray_splats.frag"},
                                                 .defines = medium}) &&
             program_init(&pass->patch_program, &patch) &&
             program_init(&pass->splat_program, &splat);
    return ok && (!pass->desc.volume || init_line_programs(pass));
}

/* A texel for each ray. */
static bool init_ray_textures(const struct caustics_pass *pass, struct texture *const textures[],
                              int count) {
    bool ok = true;
    for (int i = 0; ok && i < count; i++)
        ok = texture_init(textures[i],
                          &(struct texture_desc){.label = "light rays",
                                                 .format = GL_RGBA32F,
                                                 .width = pass->desc.size,
                                                 .height = pass->desc.size * pass->chains});
    return ok;
}

static bool init_rays(struct caustics_pass *pass) {
    struct texture *const textures[] = {&pass->leaves,     &pass->ends,       &pass->fluxes,
                                        &pass->patches[0], &pass->patches[1], &pass->splats},
                          *const between[] = {&pass->between[0], &pass->between[1]};
    bool ok = init_ray_textures(pass, textures, pass->desc.surface ? 6 : 3) &&
              init_ray_textures(pass, between, pass->desc.volume ? 2 : 0);
    struct framebuffer_desc rays = {.label = "light rays"};
    rays.colors[TARGET_RAY_LEAVE] = &pass->leaves;
    rays.colors[TARGET_RAY_END] = &pass->ends;
    rays.colors[TARGET_RAY_FLUX] = &pass->fluxes;
    if (pass->desc.volume) {
        rays.colors[TARGET_BETWEEN_LEAVE] = &pass->between[0];
        rays.colors[TARGET_BETWEEN_END] = &pass->between[1];
    }
    const struct framebuffer_desc cells = {.label = "cells of rays",
                                           .colors = {&pass->patches[0], &pass->patches[1]}},
                                  splats = {.label = "splats", .colors = {&pass->splats}};
    return ok && framebuffer_init(&pass->ray_framebuffer, &rays) &&
           (!pass->desc.surface || (framebuffer_init(&pass->cell_framebuffer, &cells) &&
                                    framebuffer_init(&pass->splat_framebuffer, &splats)));
}

static bool init_targets(struct caustics_pass *pass) {
    struct texture_desc desc = {.format = GL_RGBA32F,
                                .label = "caustics",
                                .width = pass->desc.width,
                                .height = pass->desc.height};
    bool ok = framebuffer_init_target(&pass->surface, &pass->surface_framebuffer, &desc);
    desc.label = "caustics in the medium";
    return ok && (!pass->desc.volume ||
                  framebuffer_init_target(&pass->volume, &pass->volume_framebuffer, &desc));
}

static void free_targets(struct caustics_pass *pass) {
    framebuffers_free(&pass->surface_framebuffer, &pass->volume_framebuffer);
    textures_free(&pass->surface, &pass->volume);
}

DEFINE_RESIZE(caustics_pass, surface, volume_framebuffer)

bool caustics_pass_init(struct caustics_pass *pass, const struct caustics_desc *desc) {
    *pass = (struct caustics_pass){.desc = *desc};
    pass->desc.volume = desc->volume && desc->medium;
    if (caster_pool_acquire_tree(desc->casters, &pass->tree) &&
        smooth_surfaces_init(&pass->surfaces, desc->scene, desc->geometry)) {
        pass->chains = pass->surfaces.has_glass ? desc->chains : 1;
        if (init_programs(pass) && init_rays(pass) && init_targets(pass) &&
            buffer_init(&pass->params, "caustics' parameters", sizeof(struct caustics_params),
                        NULL))
            return true;
    }
    caustics_pass_free(pass);
    return false;
}

void caustics_pass_free(struct caustics_pass *pass) {
    caster_pool_release_tree(pass->desc.casters, &pass->tree);
    smooth_surfaces_free(&pass->surfaces);
    programs_free(&pass->ray_program, &pass->cell_program, &pass->splat_list_program,
                  &pass->patch_program, &pass->splat_program, &pass->line_program,
                  &pass->between_program);
    framebuffers_free(&pass->ray_framebuffer, &pass->cell_framebuffer, &pass->splat_framebuffer);
    free_targets(pass);
    textures_free(&pass->leaves, &pass->ends, &pass->fluxes, &pass->between[0], &pass->between[1],
                  &pass->patches[0], &pass->patches[1], &pass->splats);
    buffer_free(&pass->params);
    *pass = (struct caustics_pass){0};
}

/* --- the frame -------------------------------------------------------------------------------- */

static struct pass_state state_of(const struct caustics_pass *pass, const struct frame *frame,
                                  const char *name, GLuint program) {
    struct pass_state state = {
        .name = name,
        .program = program,
        .blocks = {{BLOCK_PASS, &pass->params},
                   {BLOCK_LIGHTS, frame->lights},
                   {BLOCK_VIEW, frame->view}},
    };
    frame_add_medium(frame, &state);
    return state;
}

static void add_rays(const struct caustics_pass *pass, struct pass_state *state) {
    pass_add_texture(state, UNIT_RAY_LEAVES, pass->leaves.id);
    pass_add_texture(state, UNIT_RAY_ENDS, pass->ends.id);
    pass_add_texture(state, UNIT_RAY_FLUXES, pass->fluxes.id);
}

static int side_of(const struct caustics_pass *pass, const struct frame *frame, int light) {
    int samples = 1;
    for (int i = 0; frame->groups && i < frame->layout.groups; i++) {
        const struct light_group *group = &frame->groups[i];
        if (light >= group->first && light < group->first + group->count)
            samples = group->count;
    }
    int side = (int)lrint((double)pass->desc.size / sqrt((double)samples));
    return side < 8 ? 8 : side;
}

/* From -1/2 to 1/2: the first pass's rays are in their texels' middles. */
static float place_in_texel(uint32_t base, int pass) {
    return (float)(fmod(radical_inverse(base, (uint32_t)pass) + .5, 1) - .5);
}

/* The thesis leaves its constant solid angle of light open [Dong 2011, eq. 8.3]. Here it conserves
 * the flux of lines in all directions at the middle of glass and mirrors. Across the view a line
 * has one over a pixel's width there, 1/m. A line of another direction covers less pixels: on
 * average the square root of a half as many. */
static float line_weight(const struct caustics_pass *pass, const struct frame *frame) {
    const struct view *camera = frame->camera;
    vec3 middle, from_eye;
    smooth_surfaces_middle(&pass->surfaces, frame->geometry, middle);
    glm_vec3_sub(middle, (float *)camera->origin, from_eye);
    vec3 axis;
    view_axis(camera, axis);
    float depth = glm_vec3_dot(from_eye, axis) / glm_vec3_norm2(axis);
    float area = 4 * glm_vec3_norm((float *)camera->right) * glm_vec3_norm((float *)camera->up) /
                 (float)(pass->desc.width * pass->desc.height);
    return GLM_SQRT2f / (sqrtf(area) * (camera->orthographic ? 1 : fmaxf(depth, camera->near)));
}

static bool write_params(const struct caustics_pass *pass, const struct frame *frame, int light,
                         int *side) {
    struct caustics_params params = {
        .shift = {place_in_texel(2, frame->pass), place_in_texel(3, frame->pass)},
        .reach = reach * frame->geometry->radius,
        .far = 8 * frame->geometry->radius,
        .size = {(float)pass->desc.width, (float)pass->desc.height},
        .chains = pass->chains,
        .points_only = pass->desc.points,
        .line_step = pass->desc.step,
        .line_reach = pass->desc.step * pass->desc.kernel,
    };
    *side = side_of(pass, frame, light);
    if (!smooth_surfaces_fit(&pass->surfaces, frame->geometry, &frame->emitters->items[light],
                             *side, &params))
        return false;
    if (pass->desc.published)
        params.line_weight = line_weight(pass, frame);
    buffer_write(&pass->params, 0, sizeof params, &params);
    return true;
}

static void draw_rays(struct pass_state *state, const struct caustics_pass *pass, int side,
                      GLuint framebuffer) {
    state->framebuffer = framebuffer;
    state->width = side;
    state->height = side * pass->chains;
    pass_set_state(state);
}

static void trace(const struct caustics_pass *pass, const struct frame *frame, int light,
                  int side) {
    struct pass_state state = state_of(pass, frame, "light rays", pass->ray_program);
    smooth_surfaces_add(&pass->surfaces, &state);
    if (frame->scene->slides.id)
        pass_add_texture(&state, UNIT_SLIDES, frame->scene->slides.id);
    pass_add_texture(&state, UNIT_BVH, pass->tree->buffer.texels);
    timer_begin(frame->timers, state.name);
    draw_rays(&state, pass, side, pass->ray_framebuffer);
    pass_set_int(LOCATION_LIGHT, light);
    pass_draw_fullscreen(1);
    timer_end(frame->timers);
}

static void find_cells(const struct caustics_pass *pass, const struct frame *frame, int light,
                       int side) {
    struct pass_state cells = state_of(pass, frame, "caustics", pass->cell_program),
                      splats = state_of(pass, frame, "caustics", pass->splat_list_program);
    add_rays(pass, &cells);
    draw_rays(&cells, pass, side, pass->cell_framebuffer);
    pass_set_int(LOCATION_LIGHT, light);
    pass_draw_fullscreen(1);
    add_rays(pass, &splats);
    pass_add_texture(&splats, UNIT_PATCHES, pass->patches[0].id);
    draw_rays(&splats, pass, side, pass->splat_framebuffer);
    pass_set_int(LOCATION_LIGHT, light);
    pass_draw_fullscreen(1);
}

static struct pass_state picture_state(const struct caustics_pass *pass, const struct frame *frame,
                                       const struct gbuffer *gbuffer, const char *name,
                                       GLuint program) {
    struct pass_state state = state_of(pass, frame, name, program);
    state.width = pass->desc.width;
    state.height = pass->desc.height;
    state.blend = PASS_BLEND_ADD;
    pass_add_texture(&state, UNIT_GBUFFER_DEPTH, gbuffer->depth.id);
    return state;
}

static struct pass_state surface_state(const struct caustics_pass *pass, const struct frame *frame,
                                       const struct gbuffer *gbuffer, GLuint program) {
    struct pass_state state = picture_state(pass, frame, gbuffer, "caustics", program);
    state.framebuffer = pass->surface_framebuffer;
    add_rays(pass, &state);
    pass_add_texture(&state, UNIT_GBUFFER_NORMAL, gbuffer->normal.id);
    return state;
}

static void draw_surface(const struct caustics_pass *pass, const struct frame *frame,
                         const struct gbuffer *gbuffer, int light, int side) {
    struct pass_state patches = surface_state(pass, frame, gbuffer, pass->patch_program),
                      splats = surface_state(pass, frame, gbuffer, pass->splat_program);
    int rays = side * side * pass->chains;
    timer_begin(frame->timers, "caustics");
    find_cells(pass, frame, light, side);
    pass_add_texture(&patches, UNIT_PATCHES, pass->patches[0].id);
    pass_add_texture(&patches, UNIT_PATCHES + 1, pass->patches[1].id);
    pass_add_texture(&splats, UNIT_SPLATS, pass->splats.id);
    if (!pass->desc.points) {
        pass_set_state(&patches);
        pass_draw(GL_TRIANGLES, 6 * rays, 1);
    }
    pass_set_state(&splats);
    pass_draw(GL_TRIANGLES, 3 * rays, 1);
    timer_end(frame->timers);
}

/* A line for each ray. */
static void draw_lines(const struct caustics_pass *pass, struct pass_state *state, int light,
                       int side) {
    state->framebuffer = pass->volume_framebuffer;
    pass_set_state(state);
    pass_set_int(LOCATION_LIGHT, light);
    pass_draw(GL_LINES, 2 * side * side * pass->chains, 1);
}

static void draw_volume(const struct caustics_pass *pass, const struct frame *frame,
                        const struct gbuffer *gbuffer, int light, int side) {
    struct pass_state last = picture_state(pass, frame, gbuffer, "light lines", pass->line_program),
                      between =
                          picture_state(pass, frame, gbuffer, "light lines", pass->between_program);
    add_rays(pass, &last);
    pass_add_texture(&between, UNIT_RAY_LEAVES, pass->between[0].id);
    pass_add_texture(&between, UNIT_RAY_ENDS, pass->between[1].id);
    timer_begin(frame->timers, last.name);
    draw_lines(pass, &last, light, side);
    draw_lines(pass, &between, light, side);
    timer_end(frame->timers);
}

void caustics_pass_render(struct caustics_pass *pass, const struct frame *frame,
                          const struct gbuffer *gbuffer) {
    static const float none[4] = {0};
    smooth_surfaces_follow(&pass->surfaces, frame->scene, frame->geometry);
    framebuffer_clear_color(pass->surface_framebuffer, TARGET_RESULT, none);
    if (pass->desc.volume)
        framebuffer_clear_color(pass->volume_framebuffer, TARGET_RESULT, none);
    for (int i = 0; i < frame->emitters->count; i++) {
        int side;
        if (!write_params(pass, frame, i, &side))
            continue;
        trace(pass, frame, i, side);
        if (pass->desc.surface)
            draw_surface(pass, frame, gbuffer, i, side);
        if (pass->desc.volume)
            draw_volume(pass, frame, gbuffer, i, side);
    }
}
