#include "scene/material.h"

const char *const materials_names[] = {"full", "diffuse", NULL};

static const struct option table[] = {
    {"materials", 0, OPTION_CHOICE, offsetof(struct material_settings, materials), MATERIALS_FULL,
     .choices = materials_names,
     .help = "metals, gloss and normal maps; or every surface matt, of its base colour"},
    {NULL},
};

const struct settings_part material_part = {"surface", "surfaces", table,
                                            sizeof(struct material_settings)};

static bool has_reflectance(const struct material *material, float f0, float f90) {
    for (int c = 0; c < 3; c++)
        if (material->specular_f0[c] != f0)
            return false;
    return material->specular_f90 == f90;
}

bool material_is_matt(const struct material *material) {
    bool is_rough = material->roughness == 1 && material->metal_roughness_texture < 0;
    bool is_metal = material->metalness > 0;
    return !is_metal && (has_reflectance(material, 0, 0) ||
                         (is_rough && has_reflectance(material, DIELECTRIC_F0, 1)));
}

static bool is_plain(const struct material *material) {
    return material_is_matt(material) && material->normal_texture < 0 && !material->unlit;
}

bool materials_are_plain(const struct scene *scene) {
    for (int m = 0; m < scene->mesh_count; m++) {
        const struct mesh *mesh = &scene->meshes[m];
        for (int i = 0; i < mesh->primitive_count; i++)
            if (!is_plain(&scene->materials[mesh->primitives[i].material]))
                return false;
    }
    return true;
}
