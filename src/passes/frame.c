#include "passes/frame.h"

#include <math.h>

float frame_turn(const struct frame *frame) {
    return (float)fmod(frame->pass * .6180339887498949, 1);
}

const char *light_defines(bool has_medium, bool has_slides) {
    static const char *const defines[] = {"", "HAS_MEDIUM;", "HAS_SLIDES;",
                                          "HAS_MEDIUM;HAS_SLIDES;"};
    return defines[has_medium + 2 * has_slides];
}

void frame_add_medium(const struct frame *frame, struct pass_state *state) {
    if (!frame->medium)
        return;
    pass_add_block(state, BLOCK_MEDIUM, frame->medium);
    pass_add_texture(state, UNIT_PANES, frame->scene->panes.buffer.texels);
}

void frame_add_light(const struct frame *frame, struct pass_state *state) {
    frame_add_medium(frame, state);
    if (frame->scene->slides.id)
        pass_add_texture(state, UNIT_SLIDES, frame->scene->slides.id);
}

/* Rounding where culling and the driver clip, ndc. */
static const float clip_margin = 1e-3F;

struct draw_views frame_camera_views(const struct frame *frame, int layers, float margin) {
    return (struct draw_views){
        .count = layers, .first = frame->camera, .margin = clip_margin + margin};
}

static int first_view_of(const struct frame *frame, int kind) {
    return kind == LIGHT_MAP_FACE ? frame->layout.views[LIGHT_MAP_SINGLE] : 0;
}

struct draw_views frame_light_views(const struct frame *frame, int kind, GLuint program) {
    int first = first_view_of(frame, kind);
    const struct light_view *views = &frame->light_block->views[first];
    return (struct draw_views){.count = frame->layout.views[kind],
                               .first = &views->view,
                               .stride = sizeof *views,
                               .margin = clip_margin,
                               .program = program,
                               .first_view = first};
}

void frame_cut_by_range(const struct frame *frame, struct pass_state *state) {
    const float endless = 1e30F;
    const struct camera_range *range = &frame->camera_range;
    bool cuts = range->cuts;
    state->clip_distances =
        cuts ? 2 : 0; /* which Mesa 22's llvmpipe takes for 2 where a shader writes them */
    gl.ProgramUniform2fv(
        state->program, LOCATION_CAMERA_RANGE, 1,
        (float[]){cuts ? range->near : -endless, cuts ? fminf(range->far, endless) : endless});
}

int frame_target_views(const struct frame *frame, GLuint program, int kind) {
    gl.ProgramUniform1i(program, LOCATION_FIRST_VIEW, first_view_of(frame, kind));
    return frame->layout.views[kind];
}
