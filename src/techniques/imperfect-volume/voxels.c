#include "techniques/imperfect-volume/voxels.h"

#include "gl/program.h"
#include "passes/frame.h"

#include <stdlib.h>
#include <string.h>

static bool fits(const struct voxel_view *view, const char *defines, int width, int height) {
    return view->defines && strcmp(view->defines, defines) == 0 && view->picture.width == width &&
           view->picture.height == height;
}

bool voxel_view_fit(struct voxel_view *view, const struct volume_light *light, int width,
                    int height) {
    char *defines = volume_defines(&light->volume);
    if (fits(view, defines, width, height)) {
        free(defines);
        return true;
    }
    voxel_view_free(view);
    view->defines = defines;
    if (program_init(&view->program,
                     &(struct program_desc){.screen = {"techniques/imperfect-volume/voxels.frag"},
                                            .defines = defines}) &&
        irradiance_init(&view->picture, "inspected voxels", GL_RGBA32F, width, height, 1))
        return true;
    voxel_view_free(view);
    return false;
}

void voxel_view_free(struct voxel_view *view) {
    program_free(&view->program);
    irradiance_free(&view->picture);
    free(view->defines);
    *view = (struct voxel_view){0};
}

void voxel_view_draw(const struct voxel_view *view, const struct frame *frame,
                     const struct gbuffer *gbuffer, const struct volume_light *light) {
    const struct volume *volume = &light->volume;
    struct march_inputs reflected = volume_light_reflected(light);
    struct pass_state state = {
        .name = "inspect voxels",
        .program = view->program,
        .framebuffer = view->picture.framebuffer,
        .width = view->picture.width,
        .height = view->picture.height,
        .textures = {{UNIT_GBUFFER_DEPTH, gbuffer->depth.id},
                     {UNIT_VOLUME_SURFACES, volume->surfaces.id},
                     {UNIT_VOLUME_DISTANCES, volume->distances[0].id},
                     {UNIT_VOLUME_RADIOSITY, reflected.radiosity->id}},
        .blocks = {{BLOCK_VIEW, frame->view}, {BLOCK_PASS, &light->params}},
    };
    if (volume->desc.both_sides)
        pass_add_texture(&state, UNIT_VOLUME_BACK, reflected.back->id);
    if (volume_is_split(&volume->desc)) {
        pass_add_texture(&state, UNIT_VOLUME_TURNED_SURFACES, volume->turned_surfaces.id);
        pass_add_texture(&state, UNIT_VOLUME_TURNED_RADIOSITY, reflected.turned_radiosity->id);
    }
    pass_set_state(&state);
    pass_draw_fullscreen(1);
}
