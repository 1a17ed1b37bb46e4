#include "passes/vpls.h"

#include "gl/framebuffer.h"
#include "gl/vertex_array.h"
#include "shared/importance_map.h"
#include "shared/vpl.h"

/* Four floats of each VPL. */
static void add_attribute(const struct vpl_buffer *vpls, GLuint location, size_t offset) {
    vertex_array_attribute(
        vpls->vertices, location,
        &(struct vertex_attribute){&vpls->buffer, 4, GL_FLOAT, sizeof(struct vpl), offset});
}

static bool init_sums(struct vpl_buffer *vpls) {
    return framebuffer_init_target(
        &vpls->sums, &vpls->sums_framebuffer,
        &(struct texture_desc){.label = "sums of VPLs", .format = GL_RGBA32F, .width = 1});
}

bool vpl_buffer_init(struct vpl_buffer *vpls, const char *label, int count) {
    *vpls = (struct vpl_buffer){.count = count};
    size_t size = (size_t)(count > VPLS_PER_BLOCK ? count : VPLS_PER_BLOCK) * sizeof(struct vpl);
    if (!buffer_init_texels(&vpls->buffer, GL_RGBA32F, label, size, NULL) || !init_sums(vpls)) {
        vpl_buffer_free(vpls);
        return false;
    }
    gl.CreateVertexArrays(1, &vpls->vertices);
    add_attribute(vpls, ATTRIBUTE_VPL_POSITION, offsetof(struct vpl, position));
    add_attribute(vpls, ATTRIBUTE_VPL_NORMAL, offsetof(struct vpl, normal));
    add_attribute(vpls, ATTRIBUTE_VPL_FLUX, offsetof(struct vpl, flux));
    add_attribute(vpls, ATTRIBUTE_VPL_LOBE, offsetof(struct vpl, to_light));
    return true;
}

void vpl_buffer_take_sums(const struct vpl_buffer *vpls, const struct vpl_buffer *from) {
    gl.CopyImageSubData(from->sums.id, GL_TEXTURE_2D, 0, 0, 0, 0, vpls->sums.id, GL_TEXTURE_2D, 0,
                        0, 0, 0, 1, 1, 1);
}

void vpl_buffer_free(struct vpl_buffer *vpls) {
    framebuffer_free(&vpls->sums_framebuffer);
    texture_free(&vpls->sums);
    vertex_array_free(&vpls->vertices);
    buffer_free(&vpls->buffer);
    *vpls = (struct vpl_buffer){0};
}

void light_rays_add(struct pass_state *state, const struct light_rays *rays) {
    const struct pass_texture textures[] = {{UNIT_BVH, rays->tree},
                                            {UNIT_TRIANGLE_ALBEDOS, rays->albedos},
                                            {UNIT_SKY_PIECES, rays->sky_pieces}};
    for (size_t i = 0; i < sizeof textures / sizeof *textures; i++)
        if (textures[i].texture)
            pass_add_texture(state, textures[i].unit, textures[i].texture);
}

void importance_map_add(struct pass_state *state, const struct importance_map *map) {
    pass_add_texture(state, UNIT_IMPORTANCE_VALUES, map->values.id);
    pass_add_texture(state, UNIT_IMPORTANCE_LIGHTS, map->lights.id);
    pass_add_texture(state, UNIT_VPL_DENSITY, map->densities.id);
}
