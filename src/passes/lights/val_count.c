#include "passes/lights/val_count.h"

#include "gl/framebuffer.h"
#include "gl/pass.h"
#include "gl/program.h"

#include <cglm/util.h>

static bool init_programs(struct val_count_pass *pass) {
    return program_init(&pass->measure_program,
                        &(struct program_desc){.vertex = "lights/val_count.vert",
                                               .fragment = "lights/val_count.frag",
                                               .defines = "METRIC 0;SEEDED 0"}) &&
           program_init(&pass->seed_program,
                        &(struct program_desc){.screen = {"lights/val_count_seed.frag"}});
}

static bool init_row(struct texture *texture, const char *label, GLenum format, int width) {
    return texture_init(texture,
                        &(struct texture_desc){.label = label, .format = format, .width = width});
}

static bool init_target(struct texture *texture, GLuint *framebuffer, const char *label,
                        GLenum format, int width) {
    return init_row(texture, label, format, width) &&
           framebuffer_init(framebuffer,
                            &(struct framebuffer_desc){.label = label, .colors = {texture}});
}

/* The probe begins at the first VPLs. */
static bool init_probe(struct texture *texture) {
    float numbers[VAL_PROBES];
    for (int k = 0; k < VAL_PROBES; k++)
        numbers[k] = (float)k;
    if (!init_row(texture, "probe seeds", GL_R32F, VAL_PROBES))
        return false;
    gl.TextureSubImage2D(texture->id, 0, 0, 0, VAL_PROBES, 1, GL_RED, GL_FLOAT, numbers);
    return true;
}

bool val_count_pass_init(struct val_count_pass *pass, const struct val_count_desc *desc) {
    *pass = (struct val_count_pass){.desc = *desc};
    struct cluster_params params = {.weight_position = desc->weight_position,
                                    .weight_normal = desc->weight_normal / (float)GLM_PI,
                                    .val_count = VAL_PROBES,
                                    .distortion = desc->distortion};
    if (init_programs(pass) && init_probe(&pass->probe_seeds) &&
        init_target(&pass->distances, &pass->distance_framebuffer, "VAL distances", GL_RGBA32F,
                    1) &&
        init_target(&pass->seeds, &pass->seed_framebuffer, "VAL seeds", GL_R32F, desc->most) &&
        buffer_init(&pass->params, "VAL count parameters", sizeof params, &params))
        return true;
    val_count_pass_free(pass);
    return false;
}

void val_count_pass_free(struct val_count_pass *pass) {
    program_free(&pass->measure_program);
    program_free(&pass->seed_program);
    framebuffer_free(&pass->distance_framebuffer);
    framebuffer_free(&pass->seed_framebuffer);
    texture_free(&pass->probe_seeds);
    texture_free(&pass->distances);
    texture_free(&pass->seeds);
    buffer_free(&pass->params);
    *pass = (struct val_count_pass){0};
}

static void measure(const struct val_count_pass *pass, const struct vpl_buffer *vpls,
                    const struct val_targets *probes) {
    static const float none[4] = {0};
    framebuffer_clear_color(pass->distance_framebuffer, TARGET_RESULT, none);
    pass_set_state(&(struct pass_state){
        .name = "val count",
        .program = pass->measure_program,
        .framebuffer = pass->distance_framebuffer,
        .vertex_array = vpls->vertices,
        .width = 1,
        .height = 1,
        .blend = PASS_BLEND_ADD,
        .textures = {{UNIT_VAL_POSITION, probes->position.id},
                     {UNIT_VAL_NORMAL, probes->normal.id},
                     {UNIT_VPL_SUMS, vpls->sums.id}},
        .blocks = {{BLOCK_PASS, &pass->params}},
    });
    pass_draw(GL_POINTS, vpls->count, 1);
}

void val_count_pass_render(const struct val_count_pass *pass, const struct frame *frame,
                           const struct vpl_buffer *vpls, const struct val_targets *probes) {
    timer_begin(frame->timers, "val count");
    measure(pass, vpls, probes);
    pass_set_state(&(struct pass_state){
        .name = "val count",
        .program = pass->seed_program,
        .framebuffer = pass->seed_framebuffer,
        .width = pass->desc.most,
        .height = 1,
        .textures = {{UNIT_SUMS, pass->distances.id}},
        .blocks = {{BLOCK_PASS, &pass->params}},
    });
    pass_draw_fullscreen(1);
    timer_end(frame->timers);
}
