#include "passes/lights/cluster_light.h"

#include "base/memory.h"
#include "gl/framebuffer.h"
#include "gl/program.h"
#include "passes/frame.h"
#include "shared/gather.h"

#include <stdlib.h>

static bool init_light_program(GLuint *program, int form, bool rectangles) {
    char *defines = mem_printf("FORM %d;RECTANGLES %d", form, rectangles);
    bool ok =
        program_init(program, &(struct program_desc){.vertex = "passes/lights/cluster_light.vert",
                                                     .defines = defines});
    free(defines);
    return ok;
}

static bool init_programs(struct cluster_light_pass *pass) {
    return program_init(&pass->moment_program,
                        &(struct program_desc){.vertex = "passes/lights/cluster_moments.vert",
                                               .fragment = "passes/lights/point.frag",
                                               .defines = "PAIR"}) &&
           init_light_program(&pass->light_program, pass->desc.form, false) &&
           init_light_program(&pass->rectangle_program, pass->desc.form, true);
}

static bool init_sums(struct texture *sums, int count) {
    return texture_init(sums, &(struct texture_desc){.label = "moments of clusters",
                                                     .format = GL_RGBA32F,
                                                     .width = count});
}

bool cluster_light_pass_init(struct cluster_light_pass *pass,
                             const struct cluster_light_desc *desc) {
    *pass = (struct cluster_light_pass){.desc = *desc};
    if (init_programs(pass) && init_sums(&pass->squares, desc->count) &&
        init_sums(&pass->products, desc->count) &&
        framebuffer_init(
            &pass->framebuffer,
            &(struct framebuffer_desc){.label = "moments of clusters",
                                       .colors = {[TARGET_SUM_SQUARES] = &pass->squares,
                                                  [TARGET_SUM_PRODUCTS] = &pass->products}}) &&
        vpl_buffer_init(&pass->lights, "lights of clusters", desc->count) &&
        buffer_init(&pass->rectangles, "rectangles of lights",
                    LIGHT_RECTANGLES_MAX * sizeof(struct light_rectangle), NULL))
        return true;
    cluster_light_pass_free(pass);
    return false;
}

void cluster_light_pass_free(struct cluster_light_pass *pass) {
    programs_free(&pass->moment_program, &pass->light_program, &pass->rectangle_program);
    framebuffer_free(&pass->framebuffer);
    textures_free(&pass->squares, &pass->products);
    vpl_buffer_free(&pass->lights);
    buffer_free(&pass->rectangles);
    *pass = (struct cluster_light_pass){0};
}

static void add_moments(const struct cluster_light_pass *pass, const struct vpl_buffer *vpls,
                        const struct val_targets *means) {
    static const float none[4] = {0};
    framebuffer_clear_color(pass->framebuffer, TARGET_SUM_SQUARES, none);
    framebuffer_clear_color(pass->framebuffer, TARGET_SUM_PRODUCTS, none);
    pass_set_state(&(struct pass_state){
        .name = "lights of clusters",
        .program = pass->moment_program,
        .framebuffer = pass->framebuffer,
        .vertex_array = vpls->vertices,
        .width = pass->desc.count,
        .height = 1,
        .blend = PASS_BLEND_ADD,
        .textures = {{UNIT_VAL_POSITION, means->position.id}},
    });
    pass_draw(GL_POINTS, vpls->count, 1);
}

static void write_lights(const struct cluster_light_pass *pass, const struct val_targets *means,
                         GLuint program, const struct buffer *to) {
    pass_set_state(&(struct pass_state){
        .name = "lights of clusters",
        .program = program,
        .textures = {{UNIT_VAL_POSITION, means->position.id},
                     {UNIT_VAL_NORMAL, means->normal.id},
                     {UNIT_VAL_FLUX, means->flux.id},
                     {UNIT_SUM_SQUARES, pass->squares.id},
                     {UNIT_SUM_PRODUCTS, pass->products.id}},
    });
    pass_feedback(to->id, 0, pass->desc.count);
}

void cluster_light_pass_render(const struct cluster_light_pass *pass, const struct frame *frame,
                               const struct vpl_buffer *vpls, const struct val_targets *means) {
    timer_begin(frame->timers, "lights of clusters");
    add_moments(pass, vpls, means);
    write_lights(pass, means, pass->light_program, &pass->lights.buffer);
    write_lights(pass, means, pass->rectangle_program, &pass->rectangles);
    vpl_buffer_take_sums(&pass->lights, vpls);
    timer_end(frame->timers);
}
