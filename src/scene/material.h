/* What of a material the light sees: all of it, or the base colour alone. */
#ifndef SCENE_MATERIAL_H
#define SCENE_MATERIAL_H

#include "base/settings.h"
#include "base/unit.h"
#include "scene/scene.h"
#include "shared/brdf.h"

/* Reflectance from straight on of what has an index of refraction of 1.5. */
#define DIELECTRIC_F0 ((float)BRDF_DIELECTRIC_F0)

/* MATERIALS_DIFFUSE: every surface is Lambertian, its albedo the base colour, metals' too; no normal maps, and
 * unlit materials are lit. */
enum materials { MATERIALS_FULL, MATERIALS_DIFFUSE };

extern const char *const materials_names[];

struct material_settings {
    int materials; /* enum materials */
};

extern const struct settings_part material_part;

/* Whether the material is Lambertian under either setting, of the base colour: no metal, and without any
 * reflectance; or as rough as can be, with the reflectance that files have that do not speak of it, as plain
 * scenes have always meant it. */
bool material_is_diffuse(const struct material *material);

/* Smooth surfaces that cast caustics: glass transmits more than half of its light, mirrors are metals of roughness
 * below a tenth (chapter 8 of [Dong 2011] says "specular objects"). By the factors alone. */
enum smooth_kind { SMOOTH_NONE, SMOOTH_GLASS, SMOOTH_MIRROR };
enum smooth_kind material_smooth_kind(const struct material *material);

/* Whether that alpha is a hole of its mask. Interpolated ones are a rounding off. */
#define ALPHA_SLACK 1e-4F
static inline bool material_is_hole(const struct material *material, float alpha) {
    return material->alpha_mask && alpha < material->alpha_cutoff - ALPHA_SLACK;
}

/* Share of the light that enters and is not scattered. */
float material_transmits(const struct material *material);

/* Whether light goes straight through: blended surfaces and glass, unless they shine. */
bool material_lets_pass(const struct material *material);

/* The same of surfaces that the frame takes out of its triangles: blended ones of one alpha, and glass. */
bool material_is_pane(const struct material *material);

/* What a surface that lets light pass makes of its base colour: past it goes base, and through it glass times what its two
 * faces do not reflect. */
struct pane_color {
    vec3s glass;
    float base, index;
};
/* Of a plate between parallel faces, with all reflections within; of a negative index one face of a solid. */
float material_plate_passes(float index, float cosine);

struct pane_color material_pane_color(const struct material *material, vec4s base_color);

/* What a surface that lets light pass does to it, by its base colour there and the cosine of the angle. */
struct passing {
    vec3s passes; /* share of the light that goes straight on */
    float covers; /* share by which the surface's own light counts */
};
struct passing material_passing(const struct material *material, vec4s base_color, float cosine);

/* How a surface reflects at one place, besides its base colour: the reflectance, from straight on and
 * grazing, is of what is no metal. */
struct reflectance {
    float metalness, roughness;
    vec3s f0;
    float f90;
};

/* By the material's factors alone; and by what its metal-roughness texture has there, which it may not
 * have: it is then white. */
struct reflectance material_reflectance(const struct material *material);
struct reflectance material_reflectance_at(const struct material *material, vec4s texel);

/* The grazing reflectance of what files give no other one, by the greatest one from straight on. */
float reflectance_grazing(float f0);

/* How much of light that comes evenly a surface of that base colour reflects in all, diffusely and not. */
vec3s material_reflects(const struct material *material, vec3s base_color,
                        const struct reflectance *reflectance);

/* The mean share of even light that enters what is no metal, to be reflected diffusely. */
float reflectance_transmits(const struct reflectance *reflectance);

/* Whether all that meshes have are, and none has a normal map or is unlit: both settings make the same
 * picture. */
bool materials_are_plain(const struct scene *scene);

/* Whether a material's textures do not all lie alike. */
bool materials_have_mappings(const struct scene *scene);

#endif
