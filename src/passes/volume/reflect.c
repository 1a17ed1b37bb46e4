#include "passes/volume/reflect.h"

#include "gl/framebuffer.h"
#include "gl/program.h"
#include "passes/frame.h"
#include "passes/volumes.h"

#include <stdlib.h>

static bool init_targets(struct reflect_pass *pass, const struct volume *volume) {
    struct texture_desc sums = {.label = "volume bounce",
                                .format = GL_RGBA32F,
                                .width = volume->grid.width,
                                .height = volume->grid.height};
    struct framebuffer_desc target = {.label = sums.label};
    struct texture *made[] = {&pass->radiosity,
                              volume_is_split(&volume->desc) ? &pass->turned : NULL,
                              volume->desc.both_sides ? &pass->back : NULL};
    bool ok = true;
    for (size_t i = 0, count = 0; i < sizeof made / sizeof *made; i++)
        if (made[i]) {
            ok = ok && texture_init(made[i], &sums);
            target.colors[count++] = made[i];
        }
    return ok && framebuffer_init(&pass->framebuffer, &target);
}

bool reflect_pass_init(struct reflect_pass *pass, const struct volume *volume) {
    *pass = (struct reflect_pass){0};
    char *defines = volume_defines(volume);
    bool ok = program_init(&pass->program,
                           &(struct program_desc){.screen = {"passes/volume/reflect.frag"},
                                                  .defines = defines}) &&
              init_targets(pass, volume);
    free(defines);
    if (!ok)
        reflect_pass_free(pass);
    return ok;
}

void reflect_pass_free(struct reflect_pass *pass) {
    program_free(&pass->program);
    framebuffer_free(&pass->framebuffer);
    textures_free(&pass->radiosity, &pass->turned, &pass->back);
}

void reflect_pass_render(const struct reflect_pass *pass, const struct frame *frame,
                         const struct volume *volume, const struct buffer *params) {
    struct pass_state state = {
        .name = "reflect",
        .program = pass->program,
        .framebuffer = pass->framebuffer,
        .width = volume->grid.width,
        .height = volume->grid.height,
        .textures = {{UNIT_VOLUME_SURFACES, volume->surfaces.id},
                     {UNIT_VOLUME_RADIOSITY, volume->radiosity.id},
                     {UNIT_VOLUME_ALBEDO, volume->albedo.id},
                     {UNIT_VOLUME_DISTANCES, volume->distances[0].id}},
        .blocks = {{BLOCK_PASS, params}},
    };
    if (volume->desc.both_sides)
        pass_add_texture(&state, UNIT_VOLUME_BACK, volume->back.id);
    if (volume_is_split(&volume->desc)) {
        pass_add_texture(&state, UNIT_VOLUME_TURNED_SURFACES, volume->turned_surfaces.id);
        pass_add_texture(&state, UNIT_VOLUME_TURNED_RADIOSITY, volume->turned_radiosity.id);
    }
    for (int i = 0; i < volume->coefficient_count; i++)
        pass_add_texture(&state, UNIT_VOLUME_COEFFICIENTS + (GLuint)i, volume->coefficients[i].id);
    pass_begin(frame->timers, &state);
    pass_draw_fullscreen(1);
    pass_end(frame->timers);
}
