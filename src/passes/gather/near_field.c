#include "passes/gather/near_field.h"

#include "base/memory.h"
#include "base/spiral.h"
#include "gl/framebuffer.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "passes/frame.h"
#include "passes/lists.h"
#include "passes/vpls.h"

#include <math.h>
#include <stdlib.h>

/* Returns the samples of a pixel of an n x n pattern that takes the samples of `side` slots. */
static int samples_of_pixel(const struct near_field_desc *desc, int n, int side) {
    int share = desc->samples / (n * n), samples = (share > 0 ? share : 1) * side;
    return samples < desc->samples ? samples : desc->samples;
}

/* Returns `wanted`, but at least `least` and no more than `all`. */
static int reduced(int all, int wanted, int least) {
    least = all < least ? all : least;
    return wanted > least ? wanted : least;
}

/* Least samples that resolve a corner; least samples of one of several lights that share them. */
static const int adaptive_least = 32, light_least = 8;

static int samples_of_adaptive(const struct near_field_desc *desc, int n, int side) {
    int all = samples_of_pixel(desc, n, side);
    return n == 1 ? all : reduced(all, (int)((float)all * desc->adaptive_part), adaptive_least);
}

static bool init_programs(struct near_field_pass *pass) {
    const struct light_layout *lights = &pass->desc.lights;
    int kinds = (lights->views[LIGHT_MAP_SINGLE] > 0) << LIGHT_MAP_SINGLE |
                (lights->views[LIGHT_MAP_FACE] > 0) << LIGHT_MAP_FACE;
    int room = lights->lights > 0 ? lights->lights : 1; /* GLSL has no empty arrays */
    char *of_light = mem_printf("%s%s%sLIGHTS %d;MAP_KINDS %d;FACETS %d",
                                light_defines(pass->desc.medium, pass->desc.slides),
                                pass->desc.by_importance ? "BY_IMPORTANCE;" : "",
                                pass->desc.normal_maps ? "HAS_NORMAL_MAPS;" : "", room, kinds,
                                pass->desc.facets);
    static const char format[] = "OCCLUSION %d;RECEIVERS %d;%s";
    bool by_rays = pass->desc.occlusion == NEAR_BY_RAYS;
    char *defines = mem_printf(format, by_rays ? NEAR_BY_RAYS : NEAR_UNOCCLUDED,
                               pass->desc.adaptive ? RECEIVERS_OTHERS : RECEIVERS_ALL, of_light);
    char *adaptive = mem_printf(format, pass->desc.occlusion, RECEIVERS_ADAPTIVE, of_light);
    bool ok = program_init(&pass->light_program,
                           &(struct program_desc){
                               .screen = {"passes/gather/near_light.frag", .layers = true},
                               .defines = of_light,
                           }) &&
              program_init(&pass->program,
                           &(struct program_desc){.screen = {"passes/gather/near_field.frag",
                                                             .blended = true, .tiled = true},
                                                  .defines = defines}) &&
              (!pass->desc.adaptive ||
               program_init(&pass->adaptive_program,
                            &(struct program_desc){.vertex = "passes/gather/list_rows.vert",
                                                   .screen = {"passes/gather/near_field.frag",
                                                              .blended = true, .tiled = true},
                                                   .defines = adaptive}));
    mem_free(of_light, defines, adaptive);
    return ok;
}

static bool init_lights(struct near_field_pass *pass, int kind) {
    int size = light_map_size(kind, pass->desc.rsm_size), layers = pass->desc.lights.views[kind];
    return layers == 0 ||
           framebuffer_init_target(&pass->lights[kind], &pass->lights_framebuffers[kind],
                                   &(struct texture_desc){.label = "near lights",
                                                          .target = GL_TEXTURE_2D_ARRAY,
                                                          .format = GL_RGBA32UI,
                                                          .width = size,
                                                          .height = size,
                                                          .layers = layers});
}

bool near_field_pass_init(struct near_field_pass *pass, const struct near_field_desc *desc) {
    *pass = (struct near_field_pass){.desc = *desc};
    slot_lights_init(&pass->slot_lights, &desc->lights);
    bool ok =
        (!desc->casters || caster_pool_acquire_tree(desc->casters, &pass->tree)) &&
        init_programs(pass) &&
        buffer_init(&pass->params, "near field parameters", sizeof(struct near_field_params), NULL);
    for (int kind = 0; ok && kind < LIGHT_MAP_KINDS; kind++)
        ok = init_lights(pass, kind);
    if (!ok)
        near_field_pass_free(pass);
    return ok;
}

void near_field_pass_free(struct near_field_pass *pass) {
    caster_pool_release_tree(pass->desc.casters, &pass->tree);
    programs_free(&pass->light_program, &pass->program, &pass->adaptive_program);
    for (int kind = 0; kind < LIGHT_MAP_KINDS; kind++) {
        texture_free(&pass->lights[kind]);
        framebuffer_free(&pass->lights_framebuffers[kind]);
    }
    buffer_free(&pass->params);
    slot_lights_free(&pass->slot_lights);
    *pass = (struct near_field_pass){0};
}

static void write_params(const struct near_field_pass *pass, const struct frame *frame,
                         struct interleaving pattern) {
    double turn = 2 * acos(-1) * SPIRAL_TURN;
    struct near_field_params params = {
        .pattern = pattern,
        .power_scale =
            frame->irradiance_scale / (frame->geometry->radius * frame->geometry->radius),
        .inverse_radius = 1 / frame->geometry->radius,
        .turn = frame_turn(frame),
        .next_turn = {(float)cos(turn), (float)sin(turn)},
    };
    buffer_write(&pass->params, 0, sizeof params, &params);
}

void near_field_pass_render_lights(struct near_field_pass *pass, const struct frame *frame,
                                   const struct gbuffer rsm[LIGHT_MAP_KINDS],
                                   const struct buffer *shares,
                                   const struct importance_map *importance) {
    struct pass_state state = {
        .name = "near light",
        .program = pass->light_program,
        .blocks = {{BLOCK_LIGHTS, frame->lights},
                   {BLOCK_VPL_SHARES, shares},
                   {BLOCK_PASS, &pass->params}},
    };
    frame_add_light(frame, &state);
    rsm_add(&state, rsm);
    if (pass->desc.by_importance)
        pass_add_texture(&state, UNIT_VPL_DENSITY, importance->densities.id);
    write_params(pass, frame, (struct interleaving){.n = 1});
    timer_begin(frame->timers, "near light");
    for (int kind = 0; kind < LIGHT_MAP_KINDS; kind++)
        if (frame->layout.views[kind]) {
            state.framebuffer = pass->lights_framebuffers[kind];
            state.width = pass->lights[kind].desc.width;
            state.height = pass->lights[kind].desc.height;
            pass_set_state(&state);
            pass_draw_fullscreen(frame_target_views(frame, state.program, kind));
        }
    timer_end(frame->timers);
}

/* A draw of one tile, or of one list of a slot. */
struct near_draw {
    int slot, list;
    int lights_of, light_count; /* the slot whose lights it takes, and how many they are */
    int samples;                /* of each light */
    int pass;
};

/* llvmpipe ends the loops of a shader after 65,535 steps in all, of which a ray takes many. */
static int lights_of_draw(const struct near_field_pass *pass, const struct near_draw *draw) {
    enum { RAYS_MAX = NEAR_SAMPLES_MAX / NEAR_TOGETHER };
    int rays = (draw->samples + NEAR_TOGETHER - 1) / NEAR_TOGETHER;
    return pass->desc.occlusion == NEAR_BY_RAYS ? RAYS_MAX / rays : draw->light_count;
}

static void set_samples(int x, int y, int samples, int pass) {
    struct spiral_shift shift = spiral_shift(x, y, pass);
    double turn = 2 * acos(-1) * shift.turn;
    pass_set_ints(LOCATION_SLOT, 0, samples, x, y);
    pass_set_floats(LOCATION_NEAR_SHIFT, (float)cos(turn), (float)sin(turn), shift.along,
                    1 / (float)samples);
}

static void draw_tile(const struct near_field_pass *pass, const struct near_field_inputs *inputs,
                      struct near_draw draw) {
    int slot = draw.slot;
    const struct irradiance *irradiance = inputs->irradiance;
    int n = irradiance->interleave;
    irradiance_view_tile(irradiance, slot);
    set_samples(slot % n, slot / n, draw.samples, draw.pass);
    int together = lights_of_draw(pass, &draw);
    for (int light = 0; light < draw.light_count; light += together) {
        int rest = draw.light_count - light;
        slot_lights_set(&pass->slot_lights, draw.lights_of, light,
                        rest < together ? rest : together);
        if (inputs->of_lists)
            pixel_lists_draw(inputs->lists, draw.list);
        else
            pass_draw_fullscreen(1);
    }
}

static void draw_all(const struct near_field_pass *pass, const struct frame *frame,
                     const struct near_field_inputs *inputs) {
    int n = inputs->irradiance->interleave, slots = n * n;
    int light_count = slot_lights_allocate(&pass->slot_lights, frame, slots);
    for (int slot = 0; slot < slots; slot++)
        draw_tile(pass, inputs,
                  (struct near_draw){.slot = slot,
                                     .lights_of = slot,
                                     .light_count = light_count,
                                     .samples = samples_of_pixel(&pass->desc, n, 1),
                                     .pass = frame->pass});
}

/* List entries have few similar neighbours, so each takes all lights of a group. All lights
 * together get as many samples as the lights allocated to a pixel. */
static void draw_lists(const struct near_field_pass *pass, const struct frame *frame,
                       const struct near_field_inputs *inputs) {
    int n = inputs->irradiance->interleave, slots = n * n;
    int allocated = slot_lights_allocate(&pass->slot_lights, frame, slots);
    int light_count = slot_lights_allocate(&pass->slot_lights, frame, 1);
    for (int list = 0; list < LIST_KINDS; list++) {
        int side = pass->desc.list_slots[list];
        int all = samples_of_adaptive(&pass->desc, n, side);
        int samples = light_count > allocated
                          ? reduced(all, all * allocated / light_count, light_least)
                          : all;
        for (int slot = 0; side > 0 && slot < slots; slot++)
            draw_tile(pass, inputs,
                      (struct near_draw){.slot = slot,
                                         .list = list,
                                         .light_count = light_count,
                                         .samples = samples,
                                         .pass = frame->pass});
    }
}

void near_field_pass_render(const struct near_field_pass *pass, const struct frame *frame,
                            const struct gbuffer *gbuffer, const struct near_field_inputs *inputs) {
    const struct irradiance *irradiance = inputs->irradiance;
    struct pass_state state = {
        .name = inputs->of_lists ? "adaptive near field" : "near field",
        .program = inputs->of_lists ? pass->adaptive_program : pass->program,
        .framebuffer = irradiance->framebuffer,
        .width = irradiance->texture.desc.width,
        .height = irradiance->texture.desc.height,
        .blend = PASS_BLEND_ADD,
        .textures = {{UNIT_GBUFFER_DEPTH, gbuffer->depth.id},
                     {UNIT_GBUFFER_NORMAL, gbuffer->normal.id}},
        .blocks = {{BLOCK_VIEW, frame->view},
                   {BLOCK_LIGHTS, frame->lights},
                   {BLOCK_VPL_SHARES, inputs->shares},
                   {BLOCK_PASS, &pass->params}},
    };
    frame_add_medium(frame, &state);
    for (GLuint kind = 0; kind < LIGHT_MAP_KINDS; kind++) /* as rsm_add */
        pass_add_texture(&state, UNIT_NEAR_LIGHT + kind,
                         pass->lights[pass->lights[kind].id ? kind : !kind].id);
    pixel_lists_add(&state, inputs->lists,
                    inputs->of_lists      ? RECEIVERS_ADAPTIVE
                    : pass->desc.adaptive ? RECEIVERS_OTHERS
                                          : RECEIVERS_ALL,
                    frame->edge_samples);
    if (pass->tree)
        pass_add_texture(&state, UNIT_BVH, pass->tree->buffer.texels);
    write_params(pass, frame, irradiance_pattern(irradiance));
    pass_begin(frame->timers, &state);
    if (inputs->of_lists)
        draw_lists(pass, frame, inputs);
    else
        draw_all(pass, frame, inputs);
    pass_end(frame->timers);
}
