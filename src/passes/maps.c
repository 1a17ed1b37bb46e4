#include "passes/maps.h"

#include "gl/framebuffer.h"
#include "shared/bindings.h"

#include <stdio.h>

static bool init_map_layer(struct texture *texture, const char *label, const char *part,
                           GLenum format, const struct depth_maps *maps) {
    char full[40];
    snprintf(full, sizeof full, "%s %s", label, part);
    return texture_init(texture, &(struct texture_desc){.label = full,
                                                        .target = GL_TEXTURE_2D_ARRAY,
                                                        .format = format,
                                                        .width = maps->size,
                                                        .height = maps->size,
                                                        .layers = maps->count});
}

bool depth_maps_init(struct depth_maps *maps, const struct depth_maps_desc *desc) {
    const char *label = desc->label;
    *maps = (struct depth_maps){.size = desc->size, .count = desc->count};
    const struct texture *normal = desc->has_normals ? &maps->normal : NULL;
    if (init_map_layer(&maps->depth, label, "depth", GL_DEPTH_COMPONENT16, maps) &&
        (!normal || init_map_layer(&maps->normal, label, "normal", GL_RG16, maps)) &&
        framebuffer_init(&maps->framebuffer,
                         &(struct framebuffer_desc){.label = label,
                                                    .colors = {[TARGET_RESULT] = normal},
                                                    .depth = &maps->depth}))
        return true;
    depth_maps_free(maps);
    return false;
}

void depth_maps_free(struct depth_maps *maps) {
    framebuffer_free(&maps->framebuffer);
    textures_free(&maps->depth, &maps->normal);
    *maps = (struct depth_maps){0};
}
