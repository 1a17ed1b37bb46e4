#include "scene/material.h"

#include "shared/brdf.h"

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

static vec3s specular_f0(const struct material *material) {
    return (vec3s){{material->specular_f0[0], material->specular_f0[1], material->specular_f0[2]}};
}

float material_transmits(const struct material *material) {
    return 1 - glm_lerp(glms_vec3_max(specular_f0(material)), material->specular_f90,
                        (float)BRDF_MEAN_SCHLICK);
}

vec3s material_reflects(const struct material *material, vec3s base_color, float metalness,
                        float roughness) {
    if (material->unlit)
        return glms_vec3_zero();
    if (material_is_matt(material))
        return base_color;
    float diffuse = (1 - metalness) * material_transmits(material);
    vec3s f0 = glms_vec3_lerp(specular_f0(material), base_color, metalness);
    vec3s f90 = glms_vec3_fill(glm_lerp(material->specular_f90, 1, metalness));
    vec3s sum = glms_vec3_scale(base_color, diffuse);
    sum = glms_vec3_muladds(f0, (float)BRDF_MEAN_LOBE((double)roughness), sum);
    return glms_vec3_muladds(glms_vec3_sub(f90, f0), (float)BRDF_MEAN_GRAZING((double)roughness),
                             sum);
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
