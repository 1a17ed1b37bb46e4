#include "passes/lights/importance_map.h"

#include "base/memory.h"
#include "gl/framebuffer.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "passes/frame.h"
#include "passes/sampled_lights.h"
#include "shared/importance_map.h"
#include "shared/light_walk.h"

#include <stdlib.h>

static_assert(VPL_DENSITY_SIDE == 1 << (VPL_DENSITY_LEVELS - 1), "levels down to one cell");

/* Squared: candidates of a round. */
static int side_of(const struct importance_map_pass *pass) {
    return pass->desc.bounces > 1 || pass->desc.sky_rays || pass->desc.sampled
               ? CANDIDATES_SIDE_MANY
               : CANDIDATES_SIDE;
}

/* Area of a VPL of later bounces, over the squared radius of the scene. */
static const float later_area = 1e-3F;

static bool init_round(struct importance_map_pass *pass, int round) {
    char *defines =
        mem_printf("ROUND %d;%s%s%s%s", round, round > 0 ? "BY_IMPORTANCE;" : "",
                   pass->desc.bounces > 1 ? "LATER;" : "", pass->desc.sky_rays ? "SKY_RAYS;" : "",
                   pass->desc.sampled ? "HAS_SAMPLED;" : "");
    bool ok =
        program_init(&pass->candidate_programs[round],
                     &(struct program_desc){.screen = {"passes/lights/importance_candidate.frag"},
                                            .defines = defines}) &&
        program_init(&pass->add_programs[round],
                     &(struct program_desc){.vertex = "passes/lights/importance_add.vert",
                                            .fragment = "passes/lights/point.frag",
                                            .defines = defines});
    free(defines);
    return ok;
}

static bool init_programs(struct importance_map_pass *pass) {
    return init_round(pass, 0) && init_round(pass, 1) &&
           program_init(
               &pass->light_program,
               &(struct program_desc){.screen = {"passes/lights/importance_light.frag"}}) &&
           program_init(
               &pass->density_program,
               &(struct program_desc){.screen = {"passes/lights/importance_density.frag"}});
}

/* Numbers along both sides are powers of two, so that mip levels halve each tile. */
static void find_tiles(int lights, ivec2 tiles) {
    tiles[0] = tiles[1] = 1;
    while (tiles[0] < lights && tiles[0] < VPL_DENSITY_ROW)
        tiles[0] *= 2;
    while (tiles[1] * VPL_DENSITY_ROW < lights)
        tiles[1] *= 2;
}

static bool init_targets(struct importance_map_pass *pass) {
    ivec2 tiles;
    find_tiles(pass->desc.lights, tiles);
    struct importance_map *map = &pass->map;
    const struct texture_desc candidates = {.label = "VPL candidates",
                                            .format = GL_RGBA32F,
                                            .width = side_of(pass),
                                            .height = IMPORTANCE_ROUNDS * side_of(pass)},
                              values = {.label = "importance values",
                                        .format = GL_RG32F,
                                        .width = tiles[0] * VPL_DENSITY_SIDE,
                                        .height = tiles[1] * VPL_DENSITY_SIDE,
                                        .levels = VPL_DENSITY_LEVELS,
                                        .filter = FILTER_TRILINEAR},
                              lights = {.label = "importance of lights",
                                        .format = GL_RGBA32F,
                                        .width = pass->desc.lights,
                                        .height = 1},
                              densities = {.label = "VPL densities",
                                           .format = GL_R32F,
                                           .width = values.width,
                                           .height = values.height};
    return framebuffer_init_target(&pass->candidates, &pass->candidate_framebuffer, &candidates) &&
           framebuffer_init_target(&map->values, &pass->value_framebuffer, &values) &&
           framebuffer_init_target(&map->lights, &pass->light_framebuffer, &lights) &&
           framebuffer_init_target(&map->densities, &pass->density_framebuffer, &densities);
}

bool importance_map_pass_init(struct importance_map_pass *pass,
                              const struct importance_map_desc *desc) {
    *pass = (struct importance_map_pass){.desc = *desc};
    if (caster_pool_acquire_tree(desc->casters, &pass->bvh) && init_programs(pass) &&
        init_targets(pass) &&
        buffer_init(&pass->params, "importance map parameters",
                    sizeof(struct importance_map_params), NULL))
        return true;
    importance_map_pass_free(pass);
    return false;
}

void importance_map_pass_free(struct importance_map_pass *pass) {
    caster_pool_release_tree(pass->desc.casters, &pass->bvh);
    for (int round = 0; round < IMPORTANCE_ROUNDS; round++) {
        programs_free(&pass->candidate_programs[round], &pass->add_programs[round]);
    }
    programs_free(&pass->light_program, &pass->density_program);
    framebuffers_free(&pass->candidate_framebuffer, &pass->value_framebuffer,
                      &pass->light_framebuffer, &pass->density_framebuffer);
    textures_free(&pass->candidates, &pass->map.values, &pass->map.lights, &pass->map.densities);
    buffer_free(&pass->params);
    *pass = (struct importance_map_pass){0};
}

static void draw_candidates(const struct importance_map_pass *pass, const struct frame *frame,
                            const struct gbuffer rsm[LIGHT_MAP_KINDS],
                            const struct light_rays *rays, const struct buffer *shares, int round) {
    int side = side_of(pass);
    struct pass_state state = {
        .name = "importance map",
        .program = pass->candidate_programs[round],
        .framebuffer = pass->candidate_framebuffer,
        .y = round * side,
        .width = side,
        .height = side,
        .textures = {{UNIT_GBUFFER_DEPTH, frame->gbuffer->depth.id},
                     {UNIT_GBUFFER_NORMAL, frame->gbuffer->normal.id}},
        .blocks = {{BLOCK_VIEW, frame->view},
                   {BLOCK_LIGHTS, frame->lights},
                   {BLOCK_PASS, &pass->params},
                   {BLOCK_VPL_SHARES, shares}},
    };
    rsm_add(&state, rsm);
    light_rays_add(&state, rays);
    sampled_lights_add(frame->sampled, &state);
    if (round > 0)
        importance_map_add(&state, &pass->map);
    pass_set_state(&state);
    pass_draw_fullscreen(1);
}

/* All candidates so far, as points onto cells. */
static void add_values(const struct importance_map_pass *pass, const struct frame *frame,
                       const struct light_rays *rays, const struct buffer *shares, int round) {
    struct pass_state state = {
        .name = "importance map",
        .program = pass->add_programs[round],
        .framebuffer = pass->value_framebuffer,
        .width = pass->map.values.desc.width,
        .height = pass->map.values.desc.height,
        .blend = PASS_BLEND_ADD,
        .textures = {{UNIT_CANDIDATES, pass->candidates.id}},
        .blocks = {{BLOCK_PASS, &pass->params},
                   {BLOCK_LIGHTS, frame->lights},
                   {BLOCK_VPL_SHARES, shares}},
    };
    light_rays_add(&state, rays);
    if (round > 0)
        pass_add_texture(&state, UNIT_VPL_DENSITY, pass->map.densities.id);
    framebuffer_clear_color(pass->value_framebuffer, TARGET_RESULT, (float[]){0, 0, 0, 0});
    pass_set_state(&state);
    pass_draw(GL_POINTS, (round + 1) * side_of(pass) * side_of(pass), 1);
    gl.GenerateTextureMipmap(pass->map.values.id);
}

static void find_densities(const struct importance_map_pass *pass, const struct frame *frame,
                           const struct buffer *shares) {
    struct pass_state state = {
        .name = "importance map",
        .program = pass->light_program,
        .framebuffer = pass->light_framebuffer,
        .width = pass->map.lights.desc.width,
        .height = 1,
        .textures = {{UNIT_IMPORTANCE_VALUES, pass->map.values.id}},
        .blocks = {{BLOCK_LIGHTS, frame->lights},
                   {BLOCK_PASS, &pass->params},
                   {BLOCK_VPL_SHARES, shares}},
    };
    pass_set_state(&state);
    pass_draw_fullscreen(1);
    state.program = pass->density_program;
    state.framebuffer = pass->density_framebuffer;
    state.width = pass->map.densities.desc.width;
    state.height = pass->map.densities.desc.height;
    pass_add_texture(&state, UNIT_IMPORTANCE_LIGHTS, pass->map.lights.id);
    pass_set_state(&state);
    pass_draw_fullscreen(1);
}

void importance_map_pass_render(const struct importance_map_pass *pass, const struct frame *frame,
                                const struct gbuffer rsm[LIGHT_MAP_KINDS],
                                const struct light_rays *rays, const struct buffer *shares) {
    float radius = frame->geometry->radius;
    struct importance_map_params params = {.vpls = (float)pass->desc.vpls,
                                           .bounces = pass->desc.bounces,
                                           .start = BOUNCE_START * radius,
                                           .area = later_area * radius * radius,
                                           .side = side_of(pass)};
    find_tiles(pass->desc.lights, params.tiles);
    timer_begin(frame->timers, "importance map");
    buffer_write(&pass->params, 0, sizeof params, &params);
    for (int round = 0; round < IMPORTANCE_ROUNDS; round++) {
        draw_candidates(pass, frame, rsm, rays, shares, round);
        add_values(pass, frame, rays, shares, round);
        find_densities(pass, frame, shares);
    }
    timer_end(frame->timers);
}
