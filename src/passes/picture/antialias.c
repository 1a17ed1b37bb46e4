#include "passes/picture/antialias.h"

#include "gl/framebuffer.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "passes/frame.h"
#include "passes/targets.h"
#include "shared/antialias.h"

#include <stddef.h>
#include <stdio.h>

struct sample_layers sample_layers(int samples, int most) {
    int of_layer = SAMPLES_PER_LAYER_MIN;
    while (of_layer < samples && 2 * of_layer <= most)
        of_layer *= 2;
    return (struct sample_layers){(samples + of_layer - 1) / of_layer, of_layer};
}

/* Returns the most samples of a pixel that the driver has for both colours and depths. */
static int driver_samples(void) {
    GLint colors = 0, depths = 0;
    gl.GetIntegerv(GL_MAX_COLOR_TEXTURE_SAMPLES, &colors);
    gl.GetIntegerv(GL_MAX_DEPTH_TEXTURE_SAMPLES, &depths);
    return colors < depths ? colors : depths;
}

static bool init_programs(struct antialias_pass *pass) {
    char samples[80];
    snprintf(samples, sizeof samples, "SAMPLES %d;SAMPLES_PER_LAYER %d%s", pass->samples,
             pass->layers.samples_of_layer, pass->desc.normal_maps ? ";HAS_NORMAL_MAPS" : "");
    return program_init(&pass->solid_program,
                        &(struct program_desc){.vertex = "passes/picture/samples.vert",
                                               .fragment = "passes/picture/samples.frag"}) &&
           program_init(&pass->masked_program,
                        &(struct program_desc){.vertex = "passes/picture/samples.vert",
                                               .fragment = "passes/picture/samples.frag",
                                               .defines = "MASKED"}) &&
           program_init(
               &pass->edge_program,
               &(struct program_desc){.screen = {"passes/picture/edges.frag", .marks = true},
                                      .defines = samples}) &&
           program_init(
               &pass->assignment_program,
               &(struct program_desc){.screen = {"passes/picture/antialias.frag", .masked = true},
                                      .defines = samples});
}

static bool init_layers(const struct antialias_pass *pass, struct texture *texture,
                        const char *label, GLenum format) {
    return texture_init(texture, &(struct texture_desc){
                                     .label = label,
                                     .target = GL_TEXTURE_2D_MULTISAMPLE_ARRAY,
                                     .format = format,
                                     .width = pass->desc.width,
                                     .height = pass->desc.height,
                                     .layers = pass->layers.layers,
                                     .samples = pass->layers.samples_of_layer,
                                 });
}

static bool init_samples(struct antialias_pass *pass) {
    return init_layers(pass, &pass->depths, "sample depths", GL_DEPTH_COMPONENT32F) &&
           init_layers(pass, &pass->normals, "sample normals", GL_RGBA8) &&
           framebuffer_init(
               &pass->sample_framebuffer,
               &(struct framebuffer_desc){.label = "samples",
                                          .colors = {[TARGET_GBUFFER_NORMAL] = &pass->normals},
                                          .depth = &pass->depths});
}

static bool init_picture(const struct antialias_pass *pass, struct texture *texture,
                         const char *label, GLenum format) {
    bool all = pass->samples > 1;
    return texture_init(texture, &(struct texture_desc){.label = label,
                                                        .format = format,
                                                        .width = all ? pass->desc.width : 1,
                                                        .height = all ? pass->desc.height : 1});
}

static const GLuint itself[4] = {0}; /* the assignment where there is no edge */

static bool init_assignment(struct antialias_pass *pass) {
    if (!init_picture(pass, &pass->assignment, "sample assignment", GL_RG32UI) ||
        !init_picture(pass, &pass->edge_samples, "edge samples", GL_RGBA32UI) ||
        !pixel_mask_init(&pass->edges, "edges", pass->assignment.desc.width,
                         pass->assignment.desc.height) ||
        !framebuffer_init(&pass->assignment_framebuffer,
                          &(struct framebuffer_desc){.label = "sample assignment",
                                                     .colors = {&pass->assignment},
                                                     .depth = pixel_mask_depth(&pass->edges)}))
        return false;
    /* No program is in use that could draw integers: a driver warns of a framebuffer that is
     * cleared then. */
    gl.ClearTexImage(pass->assignment.id, 0, GL_RG_INTEGER, GL_UNSIGNED_INT, itself);
    return true;
}

/* Outermost sample, pixels from the centre: as near to the border as rasterisers resolve, so that
 * narrow slivers have samples. */
static const float outermost = .5F - 1 / 256.F;

/* Returns the shift of layer i, pixels: the outermost layers to the border, the others evenly
 * between, in different orders along x and y. A single layer keeps the driver's positions. */
static void layer_shift(const struct sample_layers *layers, int i, float shift[2]) {
    static const int orders[][SAMPLES_MAX / SAMPLES_PER_LAYER_MIN] = {
        {0}, {0, 1}, {1, 2, 0}, {2, 0, 3, 1}};
    const int n = layers->layers, at[2] = {orders[n - 1][i], i};
    /* A layer's own lie in the middles of as many parts of rows and columns. */
    float most = outermost - (.5F - .5F / (float)layers->samples_of_layer);
    for (int axis = 0; axis < 2; axis++)
        shift[axis] = n > 1 ? most * (2 * (float)at[axis] / (float)(n - 1) - 1) : 0;
}

/* The driver tells where it puts samples for the framebuffer that is bound. */
static bool init_params(struct antialias_pass *pass) {
    struct antialias_params params = {0};
    gl.BindFramebuffer(GL_FRAMEBUFFER, pass->sample_framebuffer);
    const int of_layer = pass->layers.samples_of_layer;
    for (int layer = 0; layer < pass->layers.layers; layer++) {
        float shift[2];
        layer_shift(&pass->layers, layer, shift);
        for (int axis = 0; axis < 2; axis++) {
            int pixels = axis == 0 ? pass->desc.width : pass->desc.height;
            params.shifts[layer][axis] = -2 * shift[axis] / (float)pixels;
        }
        for (int i = 0; i < of_layer; i++) {
            float *place = params.places[layer * of_layer + i];
            gl.GetMultisamplefv(GL_SAMPLE_POSITION, (GLuint)i, place);
            place[0] += shift[0] - .5F;
            place[1] += shift[1] - .5F;
        }
    }
    return buffer_init(&pass->params, "antialias parameters", sizeof params, &params);
}

bool antialias_pass_init(struct antialias_pass *pass, const struct antialias_desc *desc) {
    *pass = (struct antialias_pass){.desc = *desc};
    pass->layers = sample_layers(desc->samples, driver_samples());
    pass->samples = desc->samples > 1 ? pass->layers.layers * pass->layers.samples_of_layer : 1;
    if (init_assignment(pass) &&
        (pass->samples == 1 || (init_programs(pass) && init_samples(pass) && init_params(pass))))
        return true;
    antialias_pass_free(pass);
    return false;
}

void antialias_pass_free(struct antialias_pass *pass) {
    programs_free(&pass->solid_program, &pass->masked_program, &pass->edge_program,
                  &pass->assignment_program);
    framebuffers_free(&pass->sample_framebuffer, &pass->assignment_framebuffer);
    textures_free(&pass->depths, &pass->normals);
    pixel_mask_free(&pass->edges);
    textures_free(&pass->assignment, &pass->edge_samples);
    buffer_free(&pass->params);
    *pass = (struct antialias_pass){0};
}

void antialias_pass_place(const struct antialias_pass *pass, int i, float place[2]) {
    size_t offset = offsetof(struct antialias_params, places[i]);
    buffer_read(&pass->params, offset, 2 * sizeof *place, place);
}

/* Error of levels of detail, pixels. edges.frag lets samples lie about as far off their plane. */
static const float sample_error = .125F;

/* Draws the surfaces of the G-buffer. A rasteriser is several times faster without discarded
 * fragments, so masks are drawn apart. */
static void render_samples(const struct antialias_pass *pass, const struct frame *frame) {
    struct pass_state state = {
        .name = "samples",
        .program = pass->solid_program,
        .framebuffer = pass->sample_framebuffer,
        .vertex_array = frame->scene->shaded_vertices,
        .width = pass->desc.width,
        .height = pass->desc.height,
        .depth = PASS_DEPTH_GREATER,
        .blocks = {{BLOCK_VIEW, frame->view}, {BLOCK_PASS, &pass->params}},
    };
    frame_cut_by_range(frame, &state);
    pass_begin(frame->timers, &state);
    framebuffer_clear_depth(pass->sample_framebuffer, 0);
    /* Layers are moved by half a pixel at most. */
    float margin =
        1 / (float)(pass->desc.width < pass->desc.height ? pass->desc.width : pass->desc.height);
    struct draw_views views = frame_camera_views(frame, pass->layers.layers, margin);
    views.coarseness = 2 * sample_error / (float)pass->desc.width;
    scene_gpu_draw_solid(frame->scene, true, &views);
    state.cull = PASS_CULL_BACK;
    pass_set_state(&state);
    scene_gpu_draw_solid(frame->scene, false, &views);
    if (frame->scene->has_masked) {
        state.cull = PASS_CULL_NONE;
        state.program = pass->masked_program;
        frame_cut_by_range(frame, &state);
        pass_set_state(&state);
        scene_gpu_draw_masked(frame->scene, &views);
    }
    pass_end(frame->timers);
}

/* Most pixels have no edge, and take no part in the assignment. */
static void render_assignment(const struct antialias_pass *pass, const struct frame *frame,
                              const struct gbuffer *gbuffer) {
    struct pass_state state = {
        .name = "sample assignment",
        .program = pass->edge_program,
        .framebuffer = pass->edges.framebuffer,
        .width = pass->desc.width,
        .height = pass->desc.height,
        .depth = PASS_DEPTH_LESS,
        .mask = &pass->edges,
        .textures = {{UNIT_GBUFFER_DEPTH, gbuffer->depth.id},
                     {UNIT_GBUFFER_NORMAL, gbuffer->normal.id},
                     {UNIT_SAMPLE_DEPTH, pass->depths.id},
                     {UNIT_SAMPLE_NORMAL, pass->normals.id}},
        .blocks = {{BLOCK_VIEW, frame->view}, {BLOCK_PASS, &pass->params}},
        .images = {{IMAGE_EDGE_SAMPLES, &pass->edge_samples, 0, GL_WRITE_ONLY}},
    };
    timer_begin(frame->timers, "sample assignment");
    framebuffer_clear_integers(pass->assignment_framebuffer, TARGET_RESULT, itself);
    pixel_mask_clear(&pass->edges);
    pass_set_state(&state);
    pass_draw_fullscreen(1);
    state.program = pass->assignment_program;
    state.framebuffer = pass->assignment_framebuffer;
    state.depth = PASS_DEPTH_EQUAL;
    pass_set_state(&state);
    pass_draw_fullscreen(1);
    gl.MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
    timer_end(frame->timers);
}

void antialias_pass_render(const struct antialias_pass *pass, const struct frame *frame,
                           const struct gbuffer *gbuffer) {
    if (pass->samples == 1)
        return;
    timer_begin(frame->timers, "antialias");
    render_samples(pass, frame);
    render_assignment(pass, frame, gbuffer);
    timer_end(frame->timers);
}
