#include "passes/direct.h"

#include "gl/framebuffer.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "shared/direct.h"

bool direct_pass_init(struct direct_pass *pass, const struct direct_desc *desc) {
    *pass = (struct direct_pass){.desc = *desc};
    if (program_init(&pass->program, &(struct program_desc){.vertex = "fullscreen.vert",
                                                            .fragment = "direct.frag"}) &&
        texture_init(&pass->direct, &(struct texture_desc){.label = "direct",
                                                           .format = GL_R32F,
                                                           .width = desc->width,
                                                           .height = desc->height}) &&
        framebuffer_init(
            &pass->framebuffer,
            &(struct framebuffer_desc){.label = "direct", .colors = {&pass->direct}}) &&
        buffer_init(&pass->params, "direct parameters", sizeof(struct direct_params), NULL))
        return true;
    direct_pass_free(pass);
    return false;
}

void direct_pass_free(struct direct_pass *pass) {
    program_free(&pass->program);
    framebuffer_free(&pass->framebuffer);
    texture_free(&pass->direct);
    buffer_free(&pass->params);
    *pass = (struct direct_pass){0};
}

void direct_pass_render(const struct direct_pass *pass, const struct frame *frame,
                        const struct gbuffer *gbuffer, const struct texture *shadow_map) {
    struct direct_params params = {.bias = pass->desc.bias,
                                   .shadow_size = (float)shadow_map->desc.width};
    buffer_write(&pass->params, 0, sizeof params, &params);
    pass_begin(frame->timers, &(struct pass_state){
                                  .name = "direct",
                                  .program = pass->program,
                                  .framebuffer = pass->framebuffer,
                                  .width = pass->desc.width,
                                  .height = pass->desc.height,
                                  .textures = {{UNIT_GBUFFER_DEPTH, gbuffer->depth.id},
                                               {UNIT_GBUFFER_NORMAL, gbuffer->normal.id},
                                               {UNIT_SHADOW_MAP, shadow_map->id}},
                                  .blocks = {{BLOCK_VIEW, frame->view},
                                             {BLOCK_LIGHT, frame->light},
                                             {BLOCK_PASS, &pass->params}},
                              });
    pass_draw_fullscreen(1);
    pass_end(frame->timers);
}
