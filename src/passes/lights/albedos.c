#include "passes/lights/albedos.h"

#include "base/memory.h"
#include "scene/mesh/triangle_albedos.h"

#include <stdlib.h>

static bool find(struct albedos *albedos, const struct geometry *geometry) {
    size_t count = geometry->index_count / 3;
    struct triangle_albedo *found = mem_alloc(count, sizeof *found);
    struct surface_colors colors = {.scene = albedos->desc.scene,
                                    .geometry = geometry,
                                    .materials = albedos->desc.materials,
                                    .smooth_black = albedos->desc.smooth_black};
    texture_decode_table(colors.srgb_to_linear);
    triangle_albedos_find(found, &colors);
    bool ok = buffer_init_texels(&albedos->buffer, GL_RGBA32F, "albedos of triangles",
                                 count * sizeof *found, found);
    free(found);
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
