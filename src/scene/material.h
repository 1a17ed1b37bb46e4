/* What of a material the light sees: all of it, or the base colour alone. */
#ifndef SCENE_MATERIAL_H
#define SCENE_MATERIAL_H

#include "base/settings.h"
#include "scene/scene.h"

/* Reflectance from straight on of what has an index of refraction of 1.5. */
#define DIELECTRIC_F0 .04F

/* MATERIALS_DIFFUSE: every surface is Lambertian, its albedo the base colour, metals' too; no normal maps, and
 * unlit materials are lit. */
enum materials { MATERIALS_FULL, MATERIALS_DIFFUSE };

extern const char *const materials_names[];

struct material_settings {
    int materials; /* enum materials */
};

extern const struct settings_part material_part;

/* Whether the material is Lambertian under either setting: no metal, as rough as can be, and with the
 * reflectance that says nothing. Nothing of its reflection can be told from a diffuse one's; albedo =
 * base colour, as plain scenes have always meant it. */
bool material_is_matt(const struct material *material);

/* Whether all that meshes have are, and none has a normal map or is unlit: both settings make the same
 * picture. */
bool materials_are_plain(const struct scene *scene);

#endif
