#include "passes/gather/gather.h"

#include "base/memory.h"
#include "gl/framebuffer.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "passes/frame.h"
#include "passes/lists.h"
#include "passes/maps.h"
#include "passes/vpls.h"
#include "shared/gather.h"
#include "shared/maps.h"

#include <cglm/util.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>

static int tested_by(const struct gather_desc *desc) {
    if (desc->together > 0)
        return TESTED_BY_GROUP;
    if (!desc->share)
        return TESTED_BY_PIXEL;
    if (desc->clamp >= GATHER_CLAMP_RECTANGLE)
        return TESTED_BY_BLOCKS;
    return desc->receivers == RECEIVERS_OTHERS ? TESTED_BY_GIVEN_BLOCK : TESTED_BY_BLOCK;
}

static bool init_program(GLuint *program, const struct gather_desc *desc) {
    char *lookup = visibility_defines(&desc->visibility);
    char *defines = mem_printf(
        "%s%s%s;CUTS %d;TESTED %d;CLAMP %d;MAP_PER_VPL %d;RECEIVERS %d;SPECULAR %d",
        desc->medium ? "HAS_MEDIUM;" : "", desc->lobes ? "VPL_LOBES;" : "", lookup, desc->cuts,
        tested_by(desc), desc->clamp, desc->map_per_vpl, desc->receivers, desc->specular);
    bool ok = program_init(
        program,
        &(struct program_desc){
            .vertex = desc->receivers == RECEIVERS_ADAPTIVE ? "passes/gather/list_rows.vert" : NULL,
            .screen = {"passes/gather/gather.frag", .blended = true, .tiled = true},
            .defines = defines,
        });
    mem_free(lookup, defines);
    return ok;
}

/* Returns the descriptor of later bounces, which have no near field and no lobes. */
static struct gather_desc later_desc(const struct gather_desc *desc) {
    struct gather_desc later = *desc;
    bool rectangles =
        desc->clamp == GATHER_CLAMP_RECTANGLE || desc->clamp == GATHER_CLAMP_RECTANGLE_NEAR;
    later.clamp = rectangles ? GATHER_CLAMP_RECTANGLE : GATHER_CLAMP_PATCH;
    later.lobes = false;
    return later;
}

bool gather_pass_init(struct gather_pass *pass, const struct gather_desc *desc) {
    int size[2] = {desc->width, desc->height};
    if (desc->receivers == RECEIVERS_ADAPTIVE)
        pixel_lists_size(size, desc->interleave);
    *pass = (struct gather_pass){.desc = *desc};
    const struct gather_desc later = later_desc(desc);
    if (init_program(&pass->program, desc) &&
        (!desc->later || init_program(&pass->later_program, &later)) &&
        irradiance_init(&pass->irradiance, "gathered irradiance", GL_RGBA32F, size[0], size[1],
                        desc->interleave) &&
        buffer_init(&pass->params, "gather parameters", sizeof(struct gather_params), NULL) &&
        buffer_init(&pass->lookup_params, "lookup parameters", sizeof(struct lookup_params), NULL))
        return true;
    gather_pass_free(pass);
    return false;
}

void gather_pass_free(struct gather_pass *pass) {
    programs_free(&pass->program, &pass->later_program);
    irradiance_free(&pass->irradiance);
    buffers_free(&pass->params, &pass->lookup_params);
    *pass = (struct gather_pass){0};
}

void gather_pass_clear(const struct gather_pass *pass) {
    static const float zero[4] = {0};
    framebuffer_clear_color(pass->irradiance.framebuffer, TARGET_RESULT, zero);
}

/* Number of VPLs within a ball of radius 1. */
static const float neighbours = 10;

void gather_pass_write_params(const struct gather_pass *pass, const struct frame *frame,
                              const struct gather_inputs *inputs) {
    const struct gather_desc *desc = &pass->desc;
    bool adaptive = desc->receivers == RECEIVERS_ADAPTIVE;
    struct gather_params params = {
        .pattern = irradiance_pattern(&pass->irradiance),
        .scale = frame->irradiance_scale,
        .clamp_at = desc->clamp_value / (frame->geometry->radius * frame->geometry->radius),
        .block = desc->share ? inputs->blocks->block : 1,
        .cut_block = desc->cuts ? inputs->cuts->block : 1,
        .cut_layer = desc->cuts && adaptive ? inputs->cuts->adaptive_layer : 0,
        .sphere2 = neighbours / (float)GLM_PI * desc->sphere * desc->sphere,
        .together = desc->together,
        .specular_rays = desc->specular_rays,
        .unseen_rays = (float)desc->specular_rays / fmaxf((float)frame->layout.lights, 1),
        .turn = frame_turn(frame),
    };
    buffer_write(&pass->params, 0, sizeof params, &params);
}

static GLuint program_for(const struct gather_pass *pass, const struct gather_inputs *inputs) {
    return inputs->later ? pass->later_program : pass->program;
}

static void draw_tile(const struct gather_pass *pass, const struct gather_inputs *inputs, int slot,
                      int list) {
    irradiance_view_tile(&pass->irradiance, slot);
    if (pass->desc.receivers == RECEIVERS_ADAPTIVE)
        pixel_lists_draw(inputs->lists, list);
    else
        pass_draw_fullscreen(1);
}

/* Returns the most VPLs of one draw. llvmpipe ends the loops of a shader after 65,535 steps in all,
 * and a ray takes hundreds in a large scene. In groups one VPL of six tests visibility. */
static int vpls_of_draw(const struct gather_pass *pass) {
    bool traced = pass->desc.visibility.lookup == VISIBILITY_LOOKUP_TRACED;
    return !traced ? INT_MAX : pass->desc.together > 6 ? 6 * RAYS_MAX : RAYS_MAX;
}

/* Draws slot s of S, which has VPLs s N / S .. (s + 1) N / S. A list may take the VPLs of `side`
 * adjacent slots. */
static void draw_slot(const struct gather_pass *pass, const struct gather_inputs *inputs, int slot,
                      int list, int side) {
    int n = pass->desc.interleave, slots = n * n, total = inputs->vpls->count;
    int begin = slot / side * side, end = begin + side < slots ? begin + side : slots;
    int first = (int)((long)begin * total / slots), last = (int)((long)end * total / slots);
    float weight = (float)total / (float)(last - first);
    int range_last = inputs->count ? inputs->first + inputs->count : total;
    if (first < inputs->first)
        first = inputs->first;
    if (last > range_last)
        last = range_last;
    pass_set_float(LOCATION_SLOT_WEIGHT, weight);
    pass_set_int(LOCATION_FIRST_MAP, -inputs->first);
    for (int most = vpls_of_draw(pass), count; first < last; first += count) {
        count = last - first < most ? last - first : most;
        pass_set_ints(LOCATION_SLOT, first, count, slot % n, slot / n);
        draw_tile(pass, inputs, slot, list);
    }
}

/* Draws the cuts of a slot's set. A list may take the sets of `side` adjacent slots. */
static void draw_cuts(const struct gather_pass *pass, const struct gather_inputs *inputs, int slot,
                      int list, int side) {
    int n = pass->desc.interleave, sets = inputs->cuts->tree->sets;
    pass_set_float(LOCATION_SLOT_WEIGHT, 1 / (float)side);
    for (int i = 0; i < side; i++) {
        pass_set_ints(LOCATION_SLOT, (slot / side * side + i) % sets, 0, slot % n, slot / n);
        draw_tile(pass, inputs, slot, list);
    }
}

static void add_cuts(struct pass_state *state, const struct vpl_cuts *cuts) {
    pass_add_texture(state, UNIT_CUTS, cuts->texture.id);
    pass_add_texture(state, UNIT_TREE_NODES, cuts->tree->nodes.id);
    pass_add_texture(state, UNIT_TREE_REPRESENTATIVES, cuts->tree->representatives.id);
}

static void draw_all(const struct gather_pass *pass, const struct gather_inputs *inputs) {
    bool adaptive = pass->desc.receivers == RECEIVERS_ADAPTIVE;
    for (int list = 0; list < (adaptive ? LIST_KINDS : 1); list++) {
        int side = adaptive ? pass->desc.list_slots[list] : 1;
        for (int slot = 0; side > 0 && slot < pass->desc.interleave * pass->desc.interleave; slot++)
            (pass->desc.cuts ? draw_cuts : draw_slot)(pass, inputs, slot, list, side);
    }
}

void gather_pass_render(const struct gather_pass *pass, const struct frame *frame,
                        const struct gbuffer *gbuffer, const struct gather_inputs *inputs) {
    struct pass_state state = {
        .name = pass->desc.specular                          ? "gather, specular"
                : pass->desc.receivers == RECEIVERS_ADAPTIVE ? "adaptive gather"
                                                             : "gather",
        .program = program_for(pass, inputs),
        .framebuffer = pass->irradiance.framebuffer,
        .width = pass->irradiance.texture.desc.width,
        .height = pass->irradiance.texture.desc.height,
        .blend = PASS_BLEND_ADD,
        .textures = {{UNIT_GBUFFER_DEPTH, gbuffer->depth.id},
                     {UNIT_GBUFFER_NORMAL, gbuffer->normal.id}},
        .blocks = {{BLOCK_VIEW, frame->view}, {BLOCK_PASS, &pass->params}},
    };
    if (pass->desc.specular)
        pass_add_texture(&state, UNIT_GBUFFER_SPECULAR, gbuffer->specular.id);
    if (pass->desc.share)
        pass_add_texture(&state, UNIT_BLOCK_VISIBILITY, inputs->blocks->texture.id);
    if (inputs->kept)
        pass_add_texture(&state, UNIT_PATHS_KEPT, inputs->kept->id);
    frame_add_medium(frame, &state);
    if (inputs->rectangles)
        pass_add_block(&state, BLOCK_LIGHT_RECTANGLES, inputs->rectangles);
    pass_add_texture(&state, UNIT_VPLS,
                     pass->desc.cuts ? inputs->cuts->tree->vpls : inputs->vpls->buffer.texels);
    if (pass->desc.together > 0)
        pass_add_texture(&state, UNIT_VPL_SUMS, inputs->vpls->sums.id);
    pixel_lists_add(&state, inputs->lists, pass->desc.receivers, frame->edge_samples);
    if (pass->desc.cuts)
        add_cuts(&state, inputs->cuts);
    visibility_add(&state, &pass->desc.visibility, &pass->lookup_params, &inputs->visibility);
    gather_pass_write_params(pass, frame, inputs);
    pass_begin(frame->timers, &state);
    draw_all(pass, inputs);
    pass_end(frame->timers);
}
