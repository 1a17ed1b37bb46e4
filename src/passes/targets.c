#include "passes/targets.h"

#include "gl/framebuffer.h"
#include "shared/bindings.h"

#include <stdio.h>

static bool init_layer(struct texture *texture, const char *label, const char *part, GLenum format,
                       const struct gbuffer *gbuffer) {
    char full[40];
    snprintf(full, sizeof full, "%s %s", label, part);
    return texture_init(texture, &(struct texture_desc){.label = full,
                                                        .target = GL_TEXTURE_2D_ARRAY,
                                                        .format = format,
                                                        .width = gbuffer->width,
                                                        .height = gbuffer->height,
                                                        .layers = gbuffer->layers});
}

bool gbuffer_init(struct gbuffer *gbuffer, const struct gbuffer_desc *desc) {
    const char *label = desc->label;
    *gbuffer =
        (struct gbuffer){.width = desc->width, .height = desc->height, .layers = desc->layers};
    const struct texture *emission = desc->has_emission ? &gbuffer->emission : NULL;
    const struct texture *specular = desc->has_specular ? &gbuffer->specular : NULL;
    if (init_layer(&gbuffer->normal, label, "normal", GL_RG16, gbuffer) &&
        init_layer(&gbuffer->albedo, label, "albedo", desc->facets ? GL_RGBA16F : GL_RGBA16,
                   gbuffer) &&
        init_layer(&gbuffer->depth, label, "depth", GL_DEPTH_COMPONENT32F, gbuffer) &&
        (!desc->has_emission ||
         init_layer(&gbuffer->emission, label, "emission", GL_RGBA16F, gbuffer)) &&
        (!desc->has_specular ||
         init_layer(&gbuffer->specular, label, "specular", GL_RGBA16, gbuffer)) &&
        framebuffer_init(
            &gbuffer->framebuffer,
            &(struct framebuffer_desc){.label = label,
                                       .colors = {[TARGET_GBUFFER_NORMAL] = &gbuffer->normal,
                                                  [TARGET_GBUFFER_ALBEDO] = &gbuffer->albedo,
                                                  [TARGET_GBUFFER_EMISSION] = emission,
                                                  [TARGET_GBUFFER_SPECULAR] = specular},
                                       .depth = &gbuffer->depth}))
        return true;
    gbuffer_free(gbuffer);
    return false;
}

void gbuffer_free(struct gbuffer *gbuffer) {
    framebuffer_free(&gbuffer->framebuffer);
    textures_free(&gbuffer->normal, &gbuffer->albedo, &gbuffer->depth, &gbuffer->emission,
                  &gbuffer->specular);
    *gbuffer = (struct gbuffer){0};
}

void rsm_add(struct pass_state *state, const struct gbuffer rsm[LIGHT_MAP_KINDS]) {
    for (GLuint kind = 0; kind < LIGHT_MAP_KINDS; kind++) {
        const struct gbuffer *maps = &rsm[rsm[kind].depth.id ? kind : !kind];
        pass_add_texture(state, UNIT_RSM_DEPTH + kind, maps->depth.id);
        pass_add_texture(state, UNIT_RSM_NORMAL + kind, maps->normal.id);
        pass_add_texture(state, UNIT_RSM_ALBEDO + kind, maps->albedo.id);
        if (maps->specular.id)
            pass_add_texture(state, UNIT_RSM_SPECULAR + kind, maps->specular.id);
    }
}

bool irradiance_init(struct irradiance *irradiance, const char *label, GLenum format, int width,
                     int height, int interleave) {
    *irradiance = (struct irradiance){
        .width = width,
        .height = height,
        .interleave = interleave,
        .tile_width = (width + interleave - 1) / interleave,
        .tile_height = (height + interleave - 1) / interleave,
    };
    if (framebuffer_init_target(&irradiance->texture, &irradiance->framebuffer,
                                &(struct texture_desc){
                                    .label = label,
                                    .format = format,
                                    .width = irradiance->tile_width * interleave,
                                    .height = irradiance->tile_height * interleave,
                                }))
        return true;
    irradiance_free(irradiance);
    return false;
}

bool irradiance_resize(struct irradiance *irradiance, int width, int height) {
    const struct texture *old = &irradiance->texture;
    struct irradiance fresh;
    if (!irradiance_init(&fresh, old->label, old->desc.format, width, height,
                         irradiance->interleave))
        return false;
    irradiance_free(irradiance);
    *irradiance = fresh;
    return true;
}

struct interleaving irradiance_pattern(const struct irradiance *irradiance) {
    return (struct interleaving){
        .tile = {irradiance->tile_width, irradiance->tile_height},
        .n = irradiance->interleave,
    };
}

void irradiance_view_tile(const struct irradiance *irradiance, int slot) {
    int width = irradiance->tile_width, height = irradiance->tile_height;
    pass_viewport(slot % irradiance->interleave * width, slot / irradiance->interleave * height,
                  width, height);
}

void irradiance_free(struct irradiance *irradiance) {
    framebuffer_free(&irradiance->framebuffer);
    texture_free(&irradiance->texture);
    *irradiance = (struct irradiance){0};
}
