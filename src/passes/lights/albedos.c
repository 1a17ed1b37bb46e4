#include "passes/lights/albedos.h"

#include "base/memory.h"
#include "scene/mesh/triangle_albedos.h"

#include <cglm/cglm.h>
#include <math.h>

enum { TEXELS = 2, CHANNELS = 4 };

static uint16_t fraction(float value) {
    return (uint16_t)lrintf(65535 * glm_clamp_zo(value));
}

/* The second texel is as in glsl/lib/brdf.glsl. */
static void write_texels(const struct triangle_albedo *from, uint16_t to[TEXELS][CHANNELS]) {
    for (int c = 0; c < 3; c++) {
        to[0][c] = fraction(sqrtf(from->color[c]));
        to[1][c] = fraction(sqrtf(from->f0[c]));
    }
    to[0][3] = fraction(from->backs);
    to[1][3] = (uint16_t)(256 * lrintf(255 * glm_clamp_zo(from->roughness)) +
                          lrintf(255 * glm_clamp_zo(from->f90)));
}

static bool find(struct albedos *albedos, const struct geometry *geometry) {
    size_t count = geometry->index_count / 3;
    struct triangle_albedo *found = mem_alloc(count, sizeof *found);
    struct surface_colors colors = {.scene = albedos->desc.scene,
                                    .geometry = geometry,
                                    .materials = albedos->desc.materials,
                                    .smooth_black = albedos->desc.smooth_black};
    texture_decode_table(colors.srgb_to_linear);
    triangle_albedos_find(found, &colors);
    uint16_t(*texels)[TEXELS][CHANNELS] = mem_alloc(count, sizeof *texels);
    for (size_t i = 0; i < count; i++)
        write_texels(&found[i], texels[i]);
    bool ok = buffer_init_texels(&albedos->buffer, GL_RGBA16, "albedos of triangles",
                                 count * sizeof *texels, texels);
    mem_free(found, texels);
    albedos->painted = geometry->painted;
    return ok;
}

bool albedos_init(struct albedos *albedos, const struct albedos_desc *desc,
                  const struct geometry *geometry) {
    *albedos = (struct albedos){.desc = *desc};
    return find(albedos, geometry);
}

void albedos_free(struct albedos *albedos) {
    buffer_free(&albedos->buffer);
    *albedos = (struct albedos){.desc = albedos->desc};
}

void albedos_follow(struct albedos *albedos, const struct geometry *geometry) {
    if (albedos->buffer.id && albedos->painted != geometry->painted) {
        albedos_free(albedos);
        find(albedos, geometry);
    }
}
