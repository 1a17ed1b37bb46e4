#include "passes/gather/correction.h"

#include "base/memory.h"
#include "gl/framebuffer.h"
#include "gl/program.h"
#include "passes/frame.h"
#include "passes/maps.h"
#include "passes/targets.h"
#include "passes/vpls.h"
#include "shared/correction.h"

#include <stdlib.h>

static int group_count(const struct correction_desc *desc) {
    return (desc->vpl_count + CORRECTION_TOGETHER - 1) / CORRECTION_TOGETHER;
}

/* As wide as any driver's textures are. */
enum { TESTS_OF_CELL_MAX = 8192 };

static int cell_tests(const struct correction_desc *desc) {
    int cells = CORRECTION_SIDE * CORRECTION_SIDE;
    int tests = (desc->tests + cells - 1) / cells;
    return tests < TESTS_OF_CELL_MAX ? tests : TESTS_OF_CELL_MAX;
}

static bool init_test_program(struct correction_pass *pass) {
    char *lookup = visibility_defines(&pass->desc.visibility);
    char *defines = mem_printf("%s;CLAMP %d", lookup, pass->desc.clamp);
    bool ok = program_init(
        &pass->test_program,
        &(struct program_desc){.screen = {"gather/correction_test.frag"}, .defines = defines});
    mem_free(lookup, defines);
    return ok;
}

static bool init_programs(struct correction_pass *pass) {
    return init_test_program(pass) &&
           program_init(
               &pass->sum_program,
               &(struct program_desc){.screen = {"gather/correction_sum.frag", .layers = true}}) &&
           program_init(
               &pass->val_program,
               &(struct program_desc){.screen = {"gather/correction_val.frag", .layers = true}}) &&
           program_init(&pass->mean_program,
                        &(struct program_desc){.screen = {"gather/correction_mean.frag"}}) &&
           program_init(
               &pass->cell_program,
               &(struct program_desc){.screen = {"gather/correction_cell.frag", .layers = true}}) &&
           program_init(&pass->block_program,
                        &(struct program_desc){.vertex = "layers.vert",
                                               .fragment = "gather/correct_blocks.frag"});
}

static bool init_sums(struct texture *sums, struct texture *squares, GLuint *framebuffer,
                      const char *label, int side, int vals) {
    struct texture_desc desc = {.label = label,
                                .target = GL_TEXTURE_2D_ARRAY,
                                .format = GL_RGBA32F,
                                .width = side,
                                .height = side,
                                .layers = vals};
    bool ok = texture_init(sums, &desc);
    desc.format = GL_RG32F;
    return ok && texture_init(squares, &desc) &&
           framebuffer_init(
               framebuffer,
               &(struct framebuffer_desc){
                   .label = label,
                   .colors = {
                       [TARGET_CORRECTION_SUM] = sums, [TARGET_CORRECTION_SQUARE] = squares}});
}

static bool init_targets(struct correction_pass *pass) {
    const int vals = pass->desc.visibility.map_count;
    const struct texture_desc tests = {.label = "correction tests",
                                       .format = GL_RGBA32F,
                                       .width = cell_tests(&pass->desc),
                                       .height = CORRECTION_SIDE * CORRECTION_SIDE};
    const struct texture_desc mean = {
        .label = "mean correction", .format = GL_RG32F, .width = 1, .height = 1};
    const struct texture_desc corrections = {.label = "correction",
                                             .target = GL_TEXTURE_2D_ARRAY,
                                             .format = GL_RG16F,
                                             .width = CORRECTION_SIDE,
                                             .height = CORRECTION_SIDE,
                                             .layers = vals,
                                             .filter = FILTER_LINEAR,
                                             .wrap_s = GL_CLAMP_TO_EDGE,
                                             .wrap_t = GL_CLAMP_TO_EDGE};
    return framebuffer_init_target(&pass->tests, &pass->test_framebuffer, &tests) &&
           init_sums(&pass->sums, &pass->squares, &pass->sum_framebuffer, "correction sums",
                     CORRECTION_SIDE, vals) &&
           init_sums(&pass->val_sums, &pass->val_squares, &pass->val_framebuffer,
                     "correction sums of VALs", 1, vals) &&
           framebuffer_init_target(&pass->mean, &pass->mean_framebuffer, &mean) &&
           framebuffer_init_target(&pass->corrections, &pass->cell_framebuffer, &corrections);
}

bool correction_pass_init(struct correction_pass *pass, const struct correction_desc *desc) {
    *pass = (struct correction_pass){.desc = *desc};
    if (init_programs(pass) && init_targets(pass) &&
        buffer_init(&pass->params, "correction parameters", sizeof(struct correction_params),
                    NULL) &&
        buffer_init(&pass->lookup_params, "lookup parameters", sizeof(struct lookup_params), NULL))
        return true;
    correction_pass_free(pass);
    return false;
}

void correction_pass_free(struct correction_pass *pass) {
    programs_free(&pass->test_program, &pass->sum_program, &pass->val_program, &pass->mean_program,
                  &pass->cell_program, &pass->block_program);
    framebuffers_free(&pass->test_framebuffer, &pass->sum_framebuffer, &pass->val_framebuffer,
                      &pass->mean_framebuffer, &pass->cell_framebuffer);
    textures_free(&pass->tests, &pass->sums, &pass->squares, &pass->val_sums, &pass->val_squares,
                  &pass->mean, &pass->corrections);
    buffers_free(&pass->params, &pass->lookup_params);
    *pass = (struct correction_pass){0};
}

static void test(const struct correction_pass *pass, const struct frame *frame,
                 const struct gbuffer *gbuffer, const struct vpl_buffer *vpls,
                 const struct visibility_inputs *inputs, const struct block_visibilities *blocks) {
    struct pass_state state = {
        .name = "correction",
        .program = pass->test_program,
        .framebuffer = pass->test_framebuffer,
        .width = pass->tests.desc.width,
        .height = pass->tests.desc.height,
        .textures = {{UNIT_GBUFFER_DEPTH, gbuffer->depth.id},
                     {UNIT_GBUFFER_NORMAL, gbuffer->normal.id},
                     {UNIT_BVH, inputs->tree->buffer.texels},
                     {UNIT_VPLS, vpls->buffer.texels}},
        .blocks = {{BLOCK_VIEW, frame->view}, {BLOCK_PASS, &pass->params}},
    };
    /* Without blocks nothing is read there: any texture of layers. */
    pass_add_texture(&state, UNIT_BLOCK_VISIBILITY,
                     blocks ? blocks->texture.id : gbuffer->depth.id);
    visibility_add(&state, &pass->desc.visibility, &pass->lookup_params, inputs);
    pass_set_state(&state);
    pass_draw_fullscreen(1);
}

static void sum_tests(const struct correction_pass *pass) {
    pass_set_state(&(struct pass_state){
        .name = "correction",
        .program = pass->sum_program,
        .framebuffer = pass->sum_framebuffer,
        .width = CORRECTION_SIDE,
        .height = CORRECTION_SIDE,
        .textures = {{UNIT_CORRECTION_TESTS, pass->tests.id}},
    });
    pass_draw_fullscreen(pass->sums.desc.layers);
}

/* The state of a draw that reads sums. */
static struct pass_state over_sums(GLuint program, GLuint framebuffer, const struct texture *target,
                                   const struct texture *sums, const struct texture *squares) {
    return (struct pass_state){
        .name = "correction",
        .program = program,
        .framebuffer = framebuffer,
        .width = target->desc.width,
        .height = target->desc.height,
        .textures = {{UNIT_CORRECTION_SUMS, sums->id}, {UNIT_CORRECTION_SQUARES, squares->id}},
    };
}

static void sum_cells(const struct correction_pass *pass) {
    struct pass_state state = over_sums(pass->val_program, pass->val_framebuffer, &pass->val_sums,
                                        &pass->sums, &pass->squares);
    pass_set_state(&state);
    pass_draw_fullscreen(pass->val_sums.desc.layers);
}

static void find_mean(const struct correction_pass *pass) {
    struct pass_state state = over_sums(pass->mean_program, pass->mean_framebuffer, &pass->mean,
                                        &pass->val_sums, &pass->val_squares);
    pass_set_state(&state);
    pass_draw_fullscreen(1);
}

static void find_corrections(const struct correction_pass *pass) {
    struct pass_state state = over_sums(pass->cell_program, pass->cell_framebuffer,
                                        &pass->corrections, &pass->sums, &pass->squares);
    pass_add_texture(&state, UNIT_CORRECTION_VAL_SUMS, pass->val_sums.id);
    pass_add_texture(&state, UNIT_CORRECTION_VAL_SQUARES, pass->val_squares.id);
    pass_add_texture(&state, UNIT_CORRECTION, pass->mean.id);
    pass_set_state(&state);
    pass_draw_fullscreen(pass->corrections.desc.layers);
}

static void correct_blocks(const struct correction_pass *pass, const struct gbuffer *gbuffer,
                           const struct block_visibilities *blocks) {
    pass_set_state(&(struct pass_state){
        .name = "correction",
        .program = pass->block_program,
        .framebuffer = blocks->framebuffer,
        .width = blocks->texture.desc.width,
        .height = blocks->texture.desc.height,
        .blend = PASS_BLEND_OVER,
        .textures = {{UNIT_CORRECTION, pass->corrections.id},
                     {UNIT_GBUFFER_DEPTH, gbuffer->depth.id}},
        .blocks = {{BLOCK_PASS, &pass->params}},
    });
    pass_draw_fullscreen(blocks->texture.desc.layers);
}

void correction_pass_render(const struct correction_pass *pass, const struct frame *frame,
                            const struct gbuffer *gbuffer, const struct vpl_buffer *vpls,
                            const struct visibility_inputs *inputs,
                            const struct block_visibilities *blocks) {
    struct correction_params params = {.tests_of_cell = pass->tests.desc.width,
                                       .vpl_count = vpls->count,
                                       .groups = group_count(&pass->desc),
                                       .block = blocks ? blocks->block : 0};
    timer_begin(frame->timers, "correction");
    buffer_write(&pass->params, 0, sizeof params, &params);
    test(pass, frame, gbuffer, vpls, inputs, blocks);
    sum_tests(pass);
    sum_cells(pass);
    find_mean(pass);
    find_corrections(pass);
    if (blocks)
        correct_blocks(pass, gbuffer, blocks);
    timer_end(frame->timers);
}
