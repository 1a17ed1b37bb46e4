#include "passes/visibility/vpl_views.h"

#include "gl/pass.h"
#include "gl/program.h"
#include "passes/frame.h"
#include "passes/vpls.h"
#include "shared/maps.h"

#include <string.h>

bool vpl_views_pass_init(struct vpl_views_pass *pass, float near_clip) {
    *pass = (struct vpl_views_pass){.near_clip = near_clip};
    if (program_init(&pass->program,
                     &(struct program_desc){.vertex = "passes/visibility/vpl_views.vert"}) &&
        buffer_init(&pass->views.buffer, "map views", MAP_VIEWS_MAX * sizeof(struct map_view),
                    NULL) &&
        buffer_init(&pass->params, "view parameters", sizeof(struct vpl_views_params), NULL))
        return true;
    vpl_views_pass_free(pass);
    return false;
}

void vpl_views_pass_free(struct vpl_views_pass *pass) {
    program_free(&pass->program);
    buffers_free(&pass->views.buffer, &pass->params);
    *pass = (struct vpl_views_pass){0};
}

static void write_params(const struct vpl_views_pass *pass, const struct frame *frame) {
    struct vpl_views_params params = {.near_clip = pass->near_clip};
    memcpy(params.bounds_min, frame->geometry->bounds_min, sizeof frame->geometry->bounds_min);
    memcpy(params.bounds_max, frame->geometry->bounds_max, sizeof frame->geometry->bounds_max);
    buffer_write(&pass->params, 0, sizeof params, &params);
}

void vpl_views_pass_render(struct vpl_views_pass *pass, const struct frame *frame,
                           const struct vpl_buffer *vpls, int first, int count) {
    write_params(pass, frame);
    pass->views.count = count;
    pass_set_state(&(struct pass_state){
        .name = "depth maps",
        .program = pass->program,
        .vertex_array = vpls->vertices,
        .textures = {{UNIT_VPL_SUMS, vpls->sums.id}},
        .blocks = {{BLOCK_PASS, &pass->params}},
    });
    pass_feedback(pass->views.buffer.id, first, count);
}
