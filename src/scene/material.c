#include "scene/material.h"

#include "scene/lobe_albedo.h"
#include "shared/brdf.h"

#include <math.h>
#include <stdio.h>

const char *const materials_names[] = {"full", "diffuse", NULL};

static const struct option table[] = {
    {"materials", 0, OPTION_CHOICE, offsetof(struct material_settings, materials), MATERIALS_FULL,
     .label = "materials", .choices = materials_names,
     .help = "materials of surfaces: metals, roughness and\n"
             "normal maps, or diffuse in their base colour"},
    {NULL},
};

const struct settings_part material_part = {"surface", "surfaces", table,
                                            sizeof(struct material_settings)};

void material_init(struct material *material, const char *name) {
    *material = (struct material){.base_color = {1, 1, 1, 1},
                                  .metalness = 1,
                                  .roughness = 1,
                                  .specular_f0 = {DIELECTRIC_F0, DIELECTRIC_F0, DIELECTRIC_F0},
                                  .specular_f90 = 1,
                                  .index_of_refraction = 1.5F,
                                  .base_color_texture = -1,
                                  .metal_roughness_texture = -1,
                                  .emission_texture = -1,
                                  .normal_texture = -1,
                                  .normal_scale = 1,
                                  .emissive_strength = 1};
    snprintf(material->name, sizeof material->name, "%s", name);
}

static bool has_reflectance(const struct material *material, float f0, float f90) {
    for (int c = 0; c < 3; c++)
        if (material->specular_f0[c] != f0)
            return false;
    return material->specular_f90 == f90;
}

bool material_is_diffuse(const struct material *material) {
    bool is_rough = material->roughness == 1 && material->metal_roughness_texture < 0;
    bool is_metal = material->metalness > 0;
    return !is_metal && (has_reflectance(material, 0, 0) ||
                         (is_rough && has_reflectance(material, DIELECTRIC_F0, 1)));
}

enum smooth_kind material_smooth_kind(const struct material *material) {
    const float least_transmission = .5F, least_metalness = .9F, most_roughness = .1F;
    if (material->unlit)
        return SMOOTH_NONE;
    if (material->transmission * (1 - material->metalness) > least_transmission)
        return SMOOTH_GLASS;
    return material->metalness > least_metalness && material->roughness < most_roughness
               ? SMOOTH_MIRROR
               : SMOOTH_NONE;
}

float material_transmits(const struct material *material) {
    return material->unlit ? 0 : material->transmission * (1 - material->metalness);
}

bool material_lets_pass(const struct material *material) {
    bool shines = glm_vec3_max((float *)material->emission) > 0;
    return !shines && (material->blends || material_transmits(material) > 0);
}

bool material_is_pane(const struct material *material) {
    return material_lets_pass(material) && !(material->blends && material->alpha_mask);
}

/* The mean of both polarisations; two faces of a solid are one plate. */
float material_plate_passes(float index, float cosine) {
    bool is_face = index < 0;
    index = fabsf(index);
    cosine = fmaxf(cosine, 1e-3F);
    float within = sqrtf(fmaxf(1 - (1 - cosine * cosine) / (index * index), 0)), sum = 0;
    const float amplitudes[2] = {(cosine - index * within) / (cosine + index * within),
                                 (index * cosine - within) / (index * cosine + within)};
    for (int i = 0; i < 2; i++) {
        float reflected = amplitudes[i] * amplitudes[i];
        sum += (1 - reflected) / (1 + reflected) / 2;
    }
    return is_face ? sqrtf(sum) : sum;
}

float material_pane_passes(const struct material *material, float cosine) {
    float index = fmaxf(material->index_of_refraction, 1);
    return material_plate_passes(material->thin_walled ? index : -index, cosine);
}

struct pane_color material_pane_color(const struct material *material, vec4s base_color) {
    float covers = material->blends ? glm_clamp(base_color.a, 0, 1) : 1;
    struct pane_color pane = {.base = 1 - covers, .index = fmaxf(material->index_of_refraction, 1)};
    for (int c = 0; c < 3; c++)
        pane.glass.raw[c] = covers * material_transmits(material) *
                            glm_clamp(base_color.raw[c], 0, 1) *
                            expf(-material->absorption[c] * material->thickness / 2);
    return pane;
}

struct passing material_passing(const struct material *material, vec4s base_color, float cosine) {
    struct pane_color pane = material_pane_color(material, base_color);
    float plate = material_pane_passes(material, cosine);
    return (struct passing){glms_vec3_muladds(pane.glass, plate, glms_vec3_fill(pane.base)),
                            1 - pane.base};
}

struct reflectance material_reflectance(const struct material *material) {
    const float *f0 = material->specular_f0;
    return (struct reflectance){
        material->metalness, material->roughness, {{f0[0], f0[1], f0[2]}}, material->specular_f90};
}

float reflectance_grazing(float f0) {
    return fminf((float)BRDF_GRAZING_OF * f0, 1);
}

struct reflectance material_reflectance_at(const struct material *material, vec4s texel) {
    struct reflectance at = material_reflectance(material);
    if (material->specular_glossiness) {
        at.roughness = 1 - (1 - at.roughness) * texel.a;
        at.f0 = glms_vec3_mul(at.f0, glms_vec3(texel));
        at.f90 = reflectance_grazing(glms_vec3_max(at.f0));
    } else {
        at.roughness *= texel.g;
        at.metalness *= texel.b;
    }
    return at;
}

float reflectance_transmits(const struct reflectance *reflectance) {
    return 1 - lobe_mean_albedo(glms_vec3_max(reflectance->f0), reflectance->f90,
                                reflectance->roughness);
}

struct reflectance reflectance_lobe(const struct reflectance *reflectance, vec3s base_color) {
    struct reflectance lobe = *reflectance;
    lobe.f0 = glms_vec3_lerp(lobe.f0, base_color, lobe.metalness);
    lobe.f90 = glm_lerp(lobe.f90, 1, lobe.metalness);
    return lobe;
}

vec3s material_reflects(const struct material *material, vec3s base_color,
                        const struct reflectance *reflectance) {
    if (material->unlit)
        return glms_vec3_zero();
    if (material_is_diffuse(material))
        return base_color;
    float diffuse = (1 - reflectance->metalness) * reflectance_transmits(reflectance);
    struct reflectance lobe = reflectance_lobe(reflectance, base_color);
    vec3s sum = glms_vec3_scale(base_color, diffuse);
    for (int c = 0; c < 3; c++)
        sum.raw[c] += lobe_mean_albedo(lobe.f0.raw[c], lobe.f90, lobe.roughness);
    return sum;
}

static bool is_plain(const struct material *material) {
    return material_is_diffuse(material) && material->normal_texture < 0 && !material->unlit &&
           !material->may_shine;
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

bool materials_have_normal_maps(const struct scene *scene) {
    for (int i = 0; i < scene->material_count; i++)
        if (scene->materials[i].normal_texture >= 0)
            return true;
    return false;
}

bool materials_have_mappings(const struct scene *scene) {
    for (int i = 0; i < scene->material_count; i++) {
        const struct material *material = &scene->materials[i];
        if (material->metal_roughness_mapping || material->emission_mapping ||
            material->normal_mapping)
            return true;
    }
    return false;
}
