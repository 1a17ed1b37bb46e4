/* Optical properties of materials: full, or the base colour alone. */
#ifndef SCENE_MATERIAL_H
#define SCENE_MATERIAL_H

#include "base/settings.h"
#include "base/unit.h"
#include "scene/scene.h"
#include "shared/brdf.h"

/* Reflectance at normal incidence for an index of refraction of 1.5. */
#define DIELECTRIC_F0 ((float)BRDF_DIELECTRIC_F0)

/* MATERIALS_DIFFUSE: every surface is Lambertian with its base colour as albedo, metals too. Normal
 * maps are ignored, and unlit materials are lit. */
enum materials { MATERIALS_FULL, MATERIALS_DIFFUSE };

extern const char *const materials_names[];

struct material_settings {
    int materials; /* enum materials */
};

extern const struct settings_part material_part;

/* Makes the default material of glTF: white, rough and a metal. */
void material_init(struct material *material, const char *name);

/* True if the material is Lambertian with either setting. It is not metallic and has no specular
 * reflectance, or it has roughness 1 and glTF's default reflectance. */
bool material_is_diffuse(const struct material *material);

/* Smooth surfaces that cast caustics, by factors alone ("specular objects" in [Dong 2011 §8]).
 * Glass transmits over half of its light; mirrors are metals of roughness below .1. */
enum smooth_kind { SMOOTH_NONE, SMOOTH_GLASS, SMOOTH_MIRROR };
enum smooth_kind material_smooth_kind(const struct material *material);

/* True if alpha is a hole of the mask. Interpolation may round alpha by ALPHA_SLACK. */
#define ALPHA_SLACK 1e-4F
static inline bool material_is_hole(const struct material *material, float alpha) {
    return material->alpha_mask && alpha < material->alpha_cutoff - ALPHA_SLACK;
}

/* Returns the fraction of entering light that is not scattered. */
float material_transmits(const struct material *material);

/* True if light passes straight through: blended surfaces and glass, unless they emit. */
bool material_lets_pass(const struct material *material);

/* True for surfaces that the frame removes from its triangles: blended ones of constant alpha, and
 * glass. */
bool material_is_pane(const struct material *material);

/* Colour of a surface that light passes: light beside it is times base, light through it times
 * glass and the transmittance of its two faces. */
struct pane_color {
    vec3s glass;
    float base, index;
};
/* Returns the transmittance of a plate with parallel faces, including internal reflections; with a
 * negative index, of one face of a solid. */
float material_plate_passes(float index, float cosine);

/* Returns the transmittance of the plate, or of the face of a solid, that a pane is. It reflects
 * the rest. */
float material_pane_passes(const struct material *material, float cosine);

struct pane_color material_pane_color(const struct material *material, vec4s base_color);

/* Effect of a pane on light, by its base colour and the cosine of the angle of incidence. */
struct passing {
    vec3s passes; /* fraction of light that passes straight through */
    float covers; /* fraction of the surface's own light that counts */
};
struct passing material_passing(const struct material *material, vec4s base_color, float cosine);

/* Reflection at one point besides the base colour. f0 and f90 are the dielectric part's. */
struct reflectance {
    float metalness, roughness;
    vec3s f0;
    float f90;
};

/* Return the reflectance by the material's factors alone; and with a texel of its metal-roughness
 * texture, white without one. */
struct reflectance material_reflectance(const struct material *material);
struct reflectance material_reflectance_at(const struct material *material, vec4s texel);

/* Returns the default grazing reflectance for the greatest reflectance at normal incidence. */
float reflectance_grazing(float f0);

/* Returns the reflectance of the specular lobe, with a metal's in f0 and f90. */
struct reflectance reflectance_lobe(const struct reflectance *reflectance, vec3s base_color);

/* Returns the fraction of uniform light that a surface reflects, diffuse plus specular. */
vec3s material_reflects(const struct material *material, vec3s base_color,
                        const struct reflectance *reflectance);

/* Returns the fraction of uniform light that enters a dielectric, for diffuse reflection. */
float reflectance_transmits(const struct reflectance *reflectance);

/* True if all materials of meshes are diffuse, without normal maps, and lit. Both settings then
 * give equal pictures. */
bool materials_are_plain(const struct scene *scene);

/* True if a material has a normal map. */
bool materials_have_normal_maps(const struct scene *scene);

/* True if some material's textures have different mappings. */
bool materials_have_mappings(const struct scene *scene);

#endif
