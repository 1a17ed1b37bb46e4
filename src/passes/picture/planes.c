#include "passes/picture/planes.h"

#include "gl/framebuffer.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "passes/frame.h"

bool planes_pass_init(struct planes_pass *pass, int width, int height) {
    struct block_planes *planes = &pass->planes;
    *pass = (struct planes_pass){0};
    if (program_init(&pass->program, &(struct program_desc){.screen = {"picture/planes.frag"}}) &&
        block_texture_init(&planes->planes, "planes of blocks", GL_RGBA32F, width, height) &&
        block_texture_init(&planes->normals, "normals of blocks", GL_RGBA16, width, height) &&
        framebuffer_init(
            &pass->framebuffer,
            &(struct framebuffer_desc){.label = "planes of blocks",
                                       .colors = {[TARGET_BLOCK_PLANE] = &planes->planes,
                                                  [TARGET_BLOCK_NORMAL] = &planes->normals}}))
        return true;
    planes_pass_free(pass);
    return false;
}

void planes_pass_free(struct planes_pass *pass) {
    program_free(&pass->program);
    framebuffer_free(&pass->framebuffer);
    texture_free(&pass->planes.planes);
    texture_free(&pass->planes.normals);
    *pass = (struct planes_pass){0};
}

void planes_pass_render(const struct planes_pass *pass, const struct frame *frame,
                        const struct gbuffer *gbuffer) {
    pass_begin(frame->timers, &(struct pass_state){
                                  .name = "planes",
                                  .program = pass->program,
                                  .framebuffer = pass->framebuffer,
                                  .width = pass->planes.planes.desc.width,
                                  .height = pass->planes.planes.desc.height,
                                  .textures = {{UNIT_GBUFFER_DEPTH, gbuffer->depth.id},
                                               {UNIT_GBUFFER_NORMAL, gbuffer->normal.id}},
                                  .blocks = {{BLOCK_VIEW, frame->view}},
                              });
    pass_draw_fullscreen(1);
    pass_end(frame->timers);
}
