#include "passes/picture/geometry.h"

#include "base/memory.h"
#include "base/unit.h"
#include "gl/framebuffer.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "passes/frame.h"
#include "shared/bindings.h"

#include <stdlib.h>

bool geometry_pass_init(struct geometry_pass *pass, const struct geometry_desc *desc) {
    *pass = (struct geometry_pass){0};
    const char *mappings = desc->has_mappings ? ";HAS_MAPPINGS" : "";
    char *camera = mem_printf(
        "%s%s", desc->has_specular ? "HAS_EMISSION;HAS_SPECULAR" : "HAS_EMISSION", mappings);
    char *light = desc->has_specular ? mem_printf("LIGHT_VIEW;HAS_SPECULAR%s", mappings) : NULL;
    struct program_desc camera_desc = {.vertex = "passes/picture/geometry.vert",
                                       .fragment = "passes/picture/geometry.frag",
                                       .defines = desc->has_specular || desc->has_emission ? camera
                                                                                           : NULL};
    struct program_desc light_desc = camera_desc;
    light_desc.defines = light ? light : desc->facets ? "LIGHT_VIEW;FACETS" : "LIGHT_VIEW";
    bool ok = program_init(&pass->camera_program, &camera_desc) &&
              program_init(&pass->light_program, &light_desc);
    mem_free(camera, light);
    if (!ok)
        geometry_pass_free(pass);
    return ok;
}

void geometry_pass_free(struct geometry_pass *pass) {
    programs_free(&pass->camera_program, &pass->light_program);
}

static void clear(const struct gbuffer *gbuffer, const float normal[4], const float albedo[4],
                  float depth) {
    static const float zero[4] = {0};
    framebuffer_clear_color(gbuffer->framebuffer, TARGET_GBUFFER_NORMAL, normal);
    framebuffer_clear_color(gbuffer->framebuffer, TARGET_GBUFFER_ALBEDO, albedo);
    if (gbuffer->emission.id)
        framebuffer_clear_color(gbuffer->framebuffer, TARGET_GBUFFER_EMISSION, zero);
    if (gbuffer->specular.id)
        framebuffer_clear_color(gbuffer->framebuffer, TARGET_GBUFFER_SPECULAR, zero);
    framebuffer_clear_depth(gbuffer->framebuffer, depth);
}

/* Draws the views by the program and blocks of `state`. */
static void render(struct pass_state state, const struct frame *frame,
                   const struct gbuffer *gbuffer, struct draw_views views) {
    static const float zero[4] = {0};
    state.framebuffer = gbuffer->framebuffer;
    state.vertex_array = frame->scene->shaded_vertices;
    state.width = gbuffer->width;
    state.height = gbuffer->height;
    state.depth = PASS_DEPTH_GREATER;
    if (gbuffer->specular.id)
        pass_add_texture(&state, UNIT_LOBE_ALBEDOS, frame->scene->lobe_albedos.id);
    pass_set_state(&state);
    clear(gbuffer, zero, zero, 0);
    scene_gpu_draw_shaded(frame->scene, &views);
}

/* Fills the G-buffer with a white plane across an orthographic view, facing the camera. */
static void show_sensor(const struct frame *frame, const struct gbuffer *gbuffer) {
    static const float white[4] = {1, 1, 1, 1};
    const float *forward = frame->camera->forward;
    float code[4] = {0};
    octahedral_encode((const float[3]){-forward[0], -forward[1], -forward[2]}, code);
    clear(gbuffer, code, white, 1 - frame->sensor / frame->camera->far);
}

void geometry_pass_render_camera(const struct geometry_pass *pass, const struct frame *frame,
                                 const struct gbuffer *gbuffer) {
    struct pass_state state = {
        .name = "gbuffer", .program = pass->camera_program, .blocks = {{BLOCK_VIEW, frame->view}}};
    frame_cut_by_range(frame, &state);
    timer_begin(frame->timers, "gbuffer");
    if (frame->sensor > 0)
        show_sensor(frame, gbuffer);
    else {
        struct draw_views views = frame_camera_views(frame, 1, 0);
        views.without_backs = true;
        render(state, frame, gbuffer, views);
    }
    timer_end(frame->timers);
}

/* Error of levels of detail, texels. */
static const float rsm_error = .25F;

void geometry_pass_render_lights(const struct geometry_pass *pass, const struct frame *frame,
                                 const struct gbuffer rsm[LIGHT_MAP_KINDS]) {
    struct pass_state state = {
        .name = "rsm", .program = pass->light_program, .blocks = {{BLOCK_LIGHTS, frame->lights}}};
    timer_begin(frame->timers, "rsm");
    for (int kind = 0; kind < LIGHT_MAP_KINDS; kind++)
        if (frame->layout.views[kind]) {
            struct draw_views views = frame_light_views(frame, kind, state.program);
            views.coarseness = 2 * rsm_error / (float)rsm[kind].width;
            render(state, frame, &rsm[kind], views);
        }
    timer_end(frame->timers);
}
