#include "passes/lights/bounce.h"

#include "base/halton.h"
#include "base/memory.h"
#include "gl/framebuffer.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "passes/frame.h"
#include "passes/targets.h"
#include "shared/bounce.h"
#include "shared/light_walk.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* --- programs and targets --------------------------------------------------------------------- */

static bool init_path_program(struct bounce_pass *pass) {
    char *defines =
        mem_printf("%s%s", light_defines(pass->desc.medium, false), pass->desc.seen ? "SEEN" : "");
    const struct program_desc desc = {.screen = {"passes/lights/bounce_path.frag"},
                                      .defines = defines};
    bool ok = program_init(&pass->path_program, &desc);
    free(defines);
    return ok;
}

static bool init_programs(struct bounce_pass *pass) {
    const struct {
        GLuint *program;
        const char *fragment;
    } drawn[] = {{&pass->area_program, "passes/lights/bounce_area.frag"},
                 {&pass->share_program, "passes/lights/bounce_shares.frag"},
                 {&pass->flux_program, "passes/lights/bounce_flux.frag"},
                 {&pass->seen_program, "passes/lights/bounce_seen.frag"},
                 {&pass->kept_program, "passes/lights/bounce_kept.frag"}};
    for (size_t i = 0; i < sizeof drawn / sizeof *drawn; i++)
        if (!program_init(drawn[i].program, &(struct program_desc){.screen = {drawn[i].fragment}}))
            return false;
    return init_path_program(pass) &&
           program_init(&pass->vpl_program,
                        &(struct program_desc){.vertex = "passes/lights/bounce_vpl.vert"});
}

static struct texture_desc rows_desc(int count, int rows, GLenum format) {
    return (struct texture_desc){
        .label = "paths of light", .format = format, .width = count, .height = rows};
}

static bool init_paths(struct bounce_pass *pass) {
    const struct texture_desc desc = rows_desc(pass->desc.count, BOUNCE_ROWS, GL_RGBA32F);
    struct framebuffer_desc paths = {.label = desc.label};
    paths.colors[TARGET_BOUNCE_POSITION] = &pass->positions;
    paths.colors[TARGET_BOUNCE_NORMAL] = &pass->normals;
    paths.colors[TARGET_BOUNCE_FLUX] = &pass->fluxes;
    paths.colors[TARGET_BOUNCE_NEXT] = &pass->nexts;
    return texture_init(&pass->positions, &desc) && texture_init(&pass->normals, &desc) &&
           texture_init(&pass->fluxes, &desc) && texture_init(&pass->nexts, &desc) &&
           framebuffer_init(&pass->path_framebuffer, &paths);
}

static bool init_targets(struct bounce_pass *pass) {
    int count = pass->desc.count;
    const struct texture_desc areas = rows_desc(count, BOUNCE_ROWS, GL_R32F),
                              fluxes = rows_desc(count, BOUNCE_ROWS, GL_RGBA32F),
                              seen = rows_desc(count, 1, GL_RGBA32F),
                              kept = rows_desc(1, 1, GL_RGBA32F);
    return init_paths(pass) &&
           framebuffer_init_target(&pass->areas, &pass->area_framebuffer, &areas) &&
           framebuffer_init_target(&pass->shares, &pass->share_framebuffer, &fluxes) &&
           framebuffer_init_target(&pass->shared, &pass->shared_framebuffer, &fluxes) &&
           framebuffer_init_target(&pass->seen, &pass->seen_framebuffer, &seen) &&
           framebuffer_init_target(&pass->kept, &pass->kept_framebuffer, &kept);
}

/* --- numbers of paths ------------------------------------------------------------------------- */

/* VPLs have the dimensions of 2 and 3. The most even ones of those left are the first rays',
 * whatever the bounces. */
static double number_of(uint32_t i, int number, int axis, int seed) {
    static const uint32_t primes[][2] = {{11, 13}, {5, 7},   {17, 19}, {23, 29}, {31, 37},
                                         {41, 43}, {47, 53}, {59, 61}, {67, 71}};
    uint32_t base = primes[number][axis];
    return fmod(radical_inverse(base, i) + (seed ? radical_inverse(base, (uint32_t)seed) : 0), 1);
}

static int numbers_each(const struct bounce_pass *pass) {
    int bounces = pass->desc.bounces;
    return BOUNCE_NUMBER_RAYS + (bounces < WALK_SURE ? bounces : WALK_SURE);
}

/* Passes of a picture that converges go on in the sequence. */
static void deal_numbers(struct bounce_pass *pass, int frame_pass) {
    int count = pass->desc.count, each = numbers_each(pass);
    float(*numbers)[2] = mem_alloc((size_t)count * (size_t)(BOUNCE_ROWS * each), sizeof *numbers);
    for (int row = 0; row < BOUNCE_ROWS; row++)
        for (int number = 0; number < each; number++)
            for (int i = 0; i < count; i++)
                for (int axis = 0; axis < 2; axis++)
                    numbers[(row * each + number) * count + i][axis] = (float)number_of(
                        BOUNCE_ROWS * ((uint32_t)frame_pass * (uint32_t)count + (uint32_t)i) +
                            (uint32_t)row,
                        number, axis, pass->desc.seed);
    gl.TextureSubImage2D(pass->numbers.id, 0, 0, 0, count, BOUNCE_ROWS * each, GL_RG, GL_FLOAT,
                         numbers);
    pass->dealt_pass = frame_pass;
    free(numbers);
}

static bool init_numbers(struct bounce_pass *pass) {
    if (!texture_init(&pass->numbers,
                      &(struct texture_desc){.label = "numbers of paths",
                                             .format = GL_RG32F,
                                             .width = pass->desc.count,
                                             .height = BOUNCE_ROWS * numbers_each(pass)}))
        return false;
    deal_numbers(pass, 0);
    return true;
}

/* --- life ------------------------------------------------------------------------------------- */

bool bounce_pass_init(struct bounce_pass *pass, const struct bounce_desc *desc) {
    *pass = (struct bounce_pass){.desc = *desc};
    if (caster_pool_acquire_tree(desc->casters, &pass->tree) && init_programs(pass) &&
        init_targets(pass) && init_numbers(pass) &&
        vpl_buffer_init(&pass->vpls, "VPLs of bounces", desc->count) &&
        buffer_init(&pass->params, "paths' parameters", sizeof(struct bounce_params), NULL))
        return true;
    bounce_pass_free(pass);
    return false;
}

void bounce_pass_free(struct bounce_pass *pass) {
    caster_pool_release_tree(pass->desc.casters, &pass->tree);
    programs_free(&pass->path_program, &pass->area_program, &pass->share_program,
                  &pass->flux_program, &pass->seen_program, &pass->kept_program,
                  &pass->vpl_program);
    framebuffers_free(&pass->path_framebuffer, &pass->area_framebuffer, &pass->share_framebuffer,
                      &pass->shared_framebuffer, &pass->seen_framebuffer, &pass->kept_framebuffer);
    textures_free(&pass->numbers, &pass->positions, &pass->normals, &pass->fluxes, &pass->nexts,
                  &pass->areas, &pass->shares, &pass->shared, &pass->seen, &pass->kept);
    vpl_buffer_free(&pass->vpls);
    buffer_free(&pass->params);
    *pass = (struct bounce_pass){0};
}

/* --- the frame -------------------------------------------------------------------------------- */

static void write_params(struct bounce_pass *pass, const struct frame *frame, int vpls) {
    struct bounce_params params = {
        .vpls = vpls,
        .later = pass->desc.count,
        .bounces = pass->desc.bounces,
        .tries = pass->desc.seen ? vpls / (BOUNCE_ROWS * pass->desc.count) : 1,
        .start = BOUNCE_START * frame->geometry->radius,
        .radius = frame->geometry->radius};
    if (pass->dealt_pass != frame->pass)
        deal_numbers(pass, frame->pass);
    buffer_write(&pass->params, 0, sizeof params, &params);
}

static struct pass_state state_of(const struct bounce_pass *pass, GLuint program) {
    return (struct pass_state){
        .name = "bounces",
        .program = program,
        .textures = {{UNIT_PATH_POSITIONS, pass->positions.id},
                     {UNIT_PATH_NORMALS, pass->normals.id},
                     {UNIT_PATH_FLUXES, pass->fluxes.id},
                     {UNIT_PATH_NEXT, pass->nexts.id},
                     {UNIT_PATH_AREAS, pass->areas.id}},
        .blocks = {{BLOCK_PASS, &pass->params}},
    };
}

static void draw_rows(struct pass_state *state, GLuint framebuffer, int width, int rows) {
    state->framebuffer = framebuffer;
    state->width = width;
    state->height = rows;
    pass_set_state(state);
    pass_draw_fullscreen(1);
}

static void trace_paths(const struct bounce_pass *pass, const struct frame *frame,
                        const struct vpl_buffer *vpls, GLuint albedos) {
    struct pass_state trace = {
        .name = "bounces",
        .program = pass->path_program,
        .textures = {{UNIT_VPLS, vpls->buffer.texels},
                     {UNIT_BVH, pass->tree->buffer.texels},
                     {UNIT_TRIANGLE_ALBEDOS, albedos},
                     {UNIT_PATH_NUMBERS, pass->numbers.id}},
        .blocks = {{BLOCK_PASS, &pass->params}},
    };
    if (pass->desc.seen) {
        pass_add_block(&trace, BLOCK_VIEW, frame->view);
        pass_add_texture(&trace, UNIT_GBUFFER_DEPTH, frame->gbuffer->depth.id);
        pass_add_texture(&trace, UNIT_GBUFFER_NORMAL, frame->gbuffer->normal.id);
    }
    frame_add_medium(frame, &trace);
    draw_rows(&trace, pass->path_framebuffer, pass->desc.count, BOUNCE_ROWS);
}

void bounce_pass_render(struct bounce_pass *pass, const struct frame *frame,
                        const struct vpl_buffer *vpls, GLuint albedos) {
    int count = pass->desc.count;
    timer_begin(frame->timers, "bounces");
    write_params(pass, frame, vpls->count);
    trace_paths(pass, frame, vpls, albedos);
    struct pass_state areas = state_of(pass, pass->area_program),
                      shares = state_of(pass, pass->share_program),
                      fluxes = state_of(pass, pass->flux_program),
                      leave = state_of(pass, pass->vpl_program);
    pass_add_texture(&shares, UNIT_BVH, pass->tree->buffer.texels);
    pass_add_texture(&fluxes, UNIT_PATH_RESULTS, pass->shares.id);
    pass_add_texture(&leave, UNIT_PATH_RESULTS, pass->shared.id);
    draw_rows(&areas, pass->area_framebuffer, count, BOUNCE_ROWS);
    draw_rows(&shares, pass->share_framebuffer, count, BOUNCE_ROWS);
    draw_rows(&fluxes, pass->shared_framebuffer, count, BOUNCE_ROWS);
    pass_set_state(&leave);
    pass_feedback(pass->vpls.buffer.id, 0, count);
    timer_end(frame->timers);
}

void bounce_pass_find_kept(const struct bounce_pass *pass, const struct frame *frame) {
    struct pass_state seen = state_of(pass, pass->seen_program),
                      kept = state_of(pass, pass->kept_program);
    pass_add_texture(&seen, UNIT_BVH, pass->tree->buffer.texels);
    pass_add_block(&seen, BLOCK_VIEW, frame->view);
    pass_add_texture(&kept, UNIT_PATH_RESULTS, pass->seen.id);
    timer_begin(frame->timers, "bounces");
    draw_rows(&seen, pass->seen_framebuffer, pass->desc.count, 1);
    draw_rows(&kept, pass->kept_framebuffer, 1, 1);
    timer_end(frame->timers);
}
