#include "passes/visibility/sums.h"

#include "base/memory.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "passes/frame.h"
#include "shared/maps.h"

#include <assert.h>
#include <stdlib.h>

/* Tables a map. */
static int tables(const struct sums_desc *desc) {
    return desc->moments ? 1 : 4 * ((desc->terms + 3) / 4) + 1;
}

static bool init_programs(struct sums_pass *pass, const struct sums_desc *desc) {
    char *format = mem_printf("SUM_FORMAT %s", desc->moments == 2 ? "rg32ui" : "rgba32ui");
    char *rows = desc->moments
                     ? mem_printf("%s", format)
                     : mem_printf("%s;BASIS_TERMS %d;BASIS_GROUPS %d;MAP_COUNT %d", format,
                                  desc->terms, (desc->terms + 3) / 4, desc->count);
    char *columns = mem_printf("%s;COLUMNS", format);
    bool ok = program_init(&pass->rows_program,
                           &(struct program_desc){.compute = "passes/visibility/sum.comp",
                                                  .defines = rows}) &&
              program_init(&pass->columns_program,
                           &(struct program_desc){.compute = "passes/visibility/sum.comp",
                                                  .defines = columns});
    mem_free(format, rows, columns);
    return ok;
}

bool sums_pass_init(struct sums_pass *pass, const struct sums_desc *desc) {
    assert(desc->moments == 2 || desc->moments == 4 || (desc->moments == 0 && desc->terms > 0));
    *pass = (struct sums_pass){.maps = {.size = desc->size, .count = desc->count}};
    if (init_programs(pass, desc) &&
        texture_init(&pass->maps.sums, &(struct texture_desc){
                                           .label = "sums",
                                           .target = GL_TEXTURE_2D_ARRAY,
                                           .format = desc->moments == 2 ? GL_RG32UI : GL_RGBA32UI,
                                           .width = desc->size + 1,
                                           .height = desc->size + 1,
                                           .layers = desc->count * tables(desc),
                                       }))
        return true;
    sums_pass_free(pass);
    return false;
}

void sums_pass_free(struct sums_pass *pass) {
    programs_free(&pass->rows_program, &pass->columns_program);
    texture_free(&pass->maps.sums);
    *pass = (struct sums_pass){0};
}

static void sum_lines(const struct sums_pass *pass, struct pass_state *state, GLuint program,
                      int lines) {
    state->program = program;
    pass_set_state(state);
    pass_dispatch((lines + SUM_LINES - 1) / SUM_LINES, 1, pass->maps.sums.desc.layers);
}

void sums_pass_render(const struct sums_pass *pass, const struct frame *frame,
                      const struct texture *depth, const struct buffer *ranges) {
    struct pass_state state = {
        .name = "sums",
        .program = pass->rows_program,
        .textures = {{UNIT_MAP_DEPTH, depth->id}},
        .images = {{IMAGE_SUMS, &pass->maps.sums, 0, GL_READ_WRITE}},
    };
    if (ranges)
        pass_add_block(&state, BLOCK_SERIES_RANGES, ranges);
    timer_begin(frame->timers, state.name);
    sum_lines(pass, &state, pass->rows_program, pass->maps.size);
    state.barriers = GL_SHADER_IMAGE_ACCESS_BARRIER_BIT;
    sum_lines(pass, &state, pass->columns_program, pass->maps.size + 1);
    gl.MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
    timer_end(frame->timers);
}
