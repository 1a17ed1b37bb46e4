/* Textures as EXR files that already hold their factors, linear; alpha masks; the environment. */
#ifndef LAB_EXPORT_TEXTURES_H
#define LAB_EXPORT_TEXTURES_H

#include "base/unit.h"
#include "lab/export/target.h"

/* Writes NAME: the factor times each texel's colour. */
bool export_color_texture(const struct export_target *target, int texture, vec3s factor,
                          const char *name);

/* Writes NAME, a PNG: white where the alpha mask of the base colour lets light pass no more, else
 * black. */
bool export_mask(const struct export_target *target, const struct material *material,
                 const char *name);

/* Writes NAME, the panorama as it is: of strength 1, without its turn. */
bool export_panorama(const struct export_target *target, const char *name);

/* The same with each texel n times across and down, for who interpolates. Returns n. */
int export_panorama_repeats(const struct environment *environment);
bool export_repeated_panorama(const struct export_target *target, const char *name);

#endif
