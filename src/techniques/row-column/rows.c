#include "techniques/row-column/rows.h"

#include "base/memory.h"
#include "gl/framebuffer.h"
#include "gl/program.h"
#include "gl/vertex_array.h"
#include "passes/frame.h"
#include "passes/maps.h"
#include "shared/maps.h"

#include <math.h>

static bool init_program(GLuint *program, const struct rows_desc *desc, int clamp) {
    char *lookup = visibility_defines(&desc->visibility);
    char *defines = mem_printf("%s;CLAMP %d", lookup, clamp);
    bool ok =
        program_init(program, &(struct program_desc){.screen = {"techniques/row-column/rows.frag"},
                                                     .defines = defines});
    mem_free(lookup, defines);
    return ok;
}

static bool init_programs(struct rows_pass *pass) {
    const struct rows_desc *desc = &pass->desc;
    return program_init(&pass->pick_program,
                        &(struct program_desc){.vertex = "techniques/row-column/rows_pick.vert"}) &&
           init_program(&pass->program, desc, desc->clamp) &&
           (!desc->has_later || init_program(&pass->later_program, desc, desc->later));
}

static bool init_matrix(struct rows_pass *pass) {
    return framebuffer_init_target(&pass->matrix, &pass->framebuffer,
                                   &(struct texture_desc){.label = "rows",
                                                          .format = GL_RGBA32F,
                                                          .width = pass->desc.lights,
                                                          .height = pass->desc.rows});
}

bool rows_pass_init(struct rows_pass *pass, const struct rows_desc *desc) {
    *pass = (struct rows_pass){.desc = *desc};
    size_t rows = (size_t)desc->rows;
    pass->room = mem_alloc(rows, sizeof *pass->room);
    if (!init_programs(pass) || !init_matrix(pass) ||
        !buffer_init(&pass->places, "places of rows", rows * sizeof *pass->room, NULL) ||
        !vpl_buffer_init(&pass->pixels, "pixels of rows", desc->rows) ||
        !buffer_init(&pass->lookup_params, "lookup parameters", sizeof(struct lookup_params),
                     NULL)) {
        rows_pass_free(pass);
        return false;
    }
    gl.CreateVertexArrays(1, &pass->place_vertices);
    vertex_array_attribute(
        pass->place_vertices, ATTRIBUTE_ROW_PLACE,
        &(struct vertex_attribute){&pass->places, 2, GL_FLOAT, sizeof *pass->room, 0});
    return true;
}

void rows_pass_free(struct rows_pass *pass) {
    programs_free(&pass->pick_program, &pass->program, &pass->later_program);
    vertex_array_free(&pass->place_vertices);
    buffer_free(&pass->places);
    vpl_buffer_free(&pass->pixels);
    framebuffer_free(&pass->framebuffer);
    texture_free(&pass->matrix);
    buffer_free(&pass->lookup_params);
    free(pass->room);
    *pass = (struct rows_pass){0};
}

/* In [0, 1): a well-mixed function of all [Jarzynski and Olano 2020]. */
static float random_of(uint32_t seed, uint32_t number) {
    uint32_t state = (seed * 2654435769u + number) * 747796405u + 2891336453u;
    uint32_t word = ((state >> ((state >> 28) + 4)) ^ state) * 277803737u;
    return (float)((word >> 22 ^ word) >> 8) / 16777216.F;
}

/* Cells that are about as wide as high. Returns how many there are: r at most. */
static int place_rows(struct rows_pass *pass, const struct gbuffer *gbuffer, uint32_t seed) {
    int rows = pass->desc.rows;
    double across = sqrt(rows * (double)gbuffer->width / gbuffer->height);
    int width = (int)fmin(fmax(round(across), 1), rows), height = rows / width;
    for (int i = 0; i < width * height; i++) {
        float x = random_of(seed, 2 * (uint32_t)i), y = random_of(seed, 2 * (uint32_t)i + 1);
        pass->room[i][0] = ((float)(i % width) + x) / (float)width;
        pass->room[i][1] = ((float)(i / width) + y) / (float)height;
    }
    return width * height;
}

void rows_pass_pick(struct rows_pass *pass, const struct frame *frame,
                    const struct gbuffer *gbuffer, uint32_t seed) {
    int count = pass->pixels.count = place_rows(pass, gbuffer, seed);
    buffer_write(&pass->places, 0, (size_t)count * sizeof *pass->room, pass->room);
    pass_begin(frame->timers, &(struct pass_state){
                                  .name = "rows",
                                  .program = pass->pick_program,
                                  .vertex_array = pass->place_vertices,
                                  .textures = {{UNIT_GBUFFER_DEPTH, gbuffer->depth.id},
                                               {UNIT_GBUFFER_NORMAL, gbuffer->normal.id}},
                                  .blocks = {{BLOCK_VIEW, frame->view}},
                              });
    pass_feedback(pass->pixels.buffer.id, 0, count);
    pass_end(frame->timers);
}

void rows_pass_render(const struct rows_pass *pass, const struct frame *frame,
                      const struct rows_inputs *inputs) {
    struct pass_state state = {
        .name = "rows",
        .program = inputs->later ? pass->later_program : pass->program,
        .framebuffer = pass->framebuffer,
        .x = inputs->first_light,
        .y = inputs->first,
        .width = inputs->vpls->count,
        .height = inputs->count,
        .textures = {{UNIT_VPLS, inputs->vpls->buffer.texels}},
        .blocks = {{BLOCK_PASS, inputs->gather_params}},
    };
    /* The pixels are read from the views, whether their maps are looked up or not. */
    if (pass->desc.visibility.lookup == VISIBILITY_LOOKUP_NONE)
        pass_add_block(&state, BLOCK_MAPS, &inputs->visibility.views->buffer);
    visibility_add(&state, &pass->desc.visibility, &pass->lookup_params, &inputs->visibility);
    pass_begin(frame->timers, &state);
    gl.ProgramUniform4i(state.program, LOCATION_SLOT, inputs->first_light, inputs->first, 0, 0);
    pass_draw_fullscreen(1);
    pass_end(frame->timers);
}

void rows_pass_read(const struct rows_pass *pass, float (*matrix)[4]) {
    int lights = pass->desc.lights, rows = pass->pixels.count;
    gl.GetTextureSubImage(pass->matrix.id, 0, 0, 0, 0, lights, rows, 1, GL_RGBA, GL_FLOAT,
                          lights * rows * (GLsizei)sizeof *matrix, matrix);
}
