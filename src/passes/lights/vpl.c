#include "passes/lights/vpl.h"

#include "base/halton.h"
#include "base/memory.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "gl/vertex_array.h"
#include "shared/vpl_pass.h"

#include <math.h>
#include <stdlib.h>

static bool upload_halton(struct vpl_pass *pass) {
    int count = pass->desc.count;
    float(*points)[2] = mem_alloc((size_t)count, sizeof *points);
    /* A shift by Halton's own later points: any seed is a new, equally even set. */
    double shift[2] = {0, 0};
    if (pass->desc.seed)
        for (int axis = 0; axis < 2; axis++)
            shift[axis] = radical_inverse(axis ? 7 : 5, (uint32_t)pass->desc.seed);
    for (int i = 0; i < count; i++)
        for (int axis = 0; axis < 2; axis++)
            points[i][axis] =
                (float)fmod(radical_inverse(axis ? 3 : 2, (uint32_t)i) + shift[axis], 1);
    bool ok = buffer_init(&pass->halton, "Halton points", (size_t)count * sizeof *points, points);
    free(points);
    return ok;
}

bool vpl_pass_init(struct vpl_pass *pass, const struct vpl_desc *desc) {
    *pass = (struct vpl_pass){.desc = *desc};
    struct vpl_params params = {.count = desc->count};
    if (!upload_halton(pass) ||
        !buffer_init(&pass->params, "VPL parameters", sizeof params, &params) ||
        !program_init(&pass->program, &(struct program_desc){.vertex = "lights/vpl.vert"})) {
        vpl_pass_free(pass);
        return false;
    }
    gl.CreateVertexArrays(1, &pass->vertices);
    vertex_array_attribute(
        pass->vertices, ATTRIBUTE_HALTON,
        &(struct vertex_attribute){&pass->halton, 2, GL_FLOAT, 2 * sizeof(float), 0});
    return true;
}

void vpl_pass_free(struct vpl_pass *pass) {
    program_free(&pass->program);
    vertex_array_free(&pass->vertices);
    buffer_free(&pass->halton);
    buffer_free(&pass->params);
    *pass = (struct vpl_pass){0};
}

void vpl_pass_render(const struct vpl_pass *pass, const struct frame *frame,
                     const struct gbuffer *rsm, const struct vpl_buffer *vpls) {
    pass_begin(frame->timers,
               &(struct pass_state){
                   .name = "vpls",
                   .program = pass->program,
                   .vertex_array = pass->vertices,
                   .textures = {{UNIT_RSM_DEPTH, rsm->depth.id},
                                {UNIT_RSM_NORMAL, rsm->normal.id},
                                {UNIT_RSM_ALBEDO, rsm->albedo.id}},
                   .blocks = {{BLOCK_LIGHT, frame->light}, {BLOCK_PASS, &pass->params}},
               });
    pass_feedback(vpls->buffer.id, 0, pass->desc.count);
    pass_end(frame->timers);
}
