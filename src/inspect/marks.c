#include "inspect/marks.h"

#include "gl/pass.h"
#include "gl/program.h"
#include "passes/frame.h"
#include "passes/maps.h"
#include "passes/targets.h"
#include "passes/vpls.h"
#include "shared/inspect.h"
#include "shared/vpl.h"

#include <math.h>

enum { VAL_VERTICES = 5 * 6 }; /* four edges and a normal, two triangles each */

bool marks_init(struct marks *marks) {
    *marks = (struct marks){0};
    if (program_init(&marks->point_program,
                     &(struct program_desc){.vertex = "inspect/mark_points.vert",
                                            .fragment = "inspect/mark.frag"}) &&
        program_init(&marks->val_program, &(struct program_desc){.vertex = "inspect/mark_vals.vert",
                                                                 .fragment = "inspect/mark.frag",
                                                                 .defines = "LINES"}) &&
        buffer_init(&marks->params, "mark parameters", sizeof(struct mark_params), NULL))
        return true;
    marks_free(marks);
    return false;
}

void marks_free(struct marks *marks) {
    programs_free(&marks->point_program, &marks->val_program);
    buffer_free(&marks->params);
}

static void write_params(const struct marks *marks, const struct frame *frame,
                         const struct marks_desc *desc, float size) {
    struct mark_params params = {
        .picture = {(float)desc->width, (float)desc->height},
        .size = size * desc->scale,
        .by_cluster = desc->by_cluster,
        .flux_scale = 1 / fmaxf(desc->usual_flux, 1e-30F),
        .normal_length = .14F * frame->geometry->radius,
        .chosen = desc->chosen,
        .only_chosen = desc->only_chosen,
    };
    buffer_write(&marks->params, 0, sizeof params, &params);
}

/* Of points and lines alike. */
static struct pass_state state_of(const struct marks *marks, const struct frame *frame,
                                  const struct gbuffer *gbuffer, const struct marks_desc *desc) {
    return (struct pass_state){
        .name = "marks",
        .framebuffer = desc->framebuffer,
        .width = desc->width,
        .height = desc->height,
        .blend = PASS_BLEND_OVER,
        .textures = {{UNIT_GBUFFER_DEPTH, gbuffer->depth.id}},
        .blocks = {{BLOCK_VIEW, frame->view}, {BLOCK_PASS, &marks->params}},
    };
}

static void draw_vpls(const struct marks *marks, const struct frame *frame,
                      const struct gbuffer *gbuffer, const struct marks_desc *desc) {
    struct pass_state state = state_of(marks, frame, gbuffer, desc);
    state.program = marks->point_program;
    state.vertex_array = desc->vpls->vertices;
    state.point_size = true;
    /* Fewer VPLs, larger discs. */
    write_params(marks, frame, desc, fminf(fmaxf(260 / sqrtf((float)desc->vpls->count), 3), 9));
    pass_set_state(&state);
    pass_draw(GL_POINTS, desc->vpls->count, 1);
}

static void draw_vals(const struct marks *marks, const struct frame *frame,
                      const struct gbuffer *gbuffer, const struct marks_desc *desc) {
    const struct map_views *views = desc->vals->maps.views;
    struct pass_state state = state_of(marks, frame, gbuffer, desc);
    state.program = marks->val_program;
    pass_add_texture(&state, UNIT_VAL_EXTREMES, desc->vals->extremes->id);
    pass_add_texture(&state, UNIT_VAL_POSITION, desc->vals->positions->id);
    pass_add_block(&state, BLOCK_MAPS, &views->buffer);
    write_params(marks, frame, desc, 1.6F);
    pass_set_state(&state);
    pass_draw(GL_TRIANGLES, VAL_VERTICES, views->count);
}

void marks_draw(const struct marks *marks, const struct frame *frame, const struct gbuffer *gbuffer,
                const struct marks_desc *desc) {
    if (desc->vpls)
        draw_vpls(marks, frame, gbuffer, desc);
    if (desc->vals)
        draw_vals(marks, frame, gbuffer, desc);
}

void marks_cluster_color(int k, unsigned char rgb[3]) {
    for (int c = 0; c < 3; c++)
        rgb[c] = (unsigned char)lrintf(255 * cluster_color(k, c));
}
