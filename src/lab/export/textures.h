/* Writes textures with their factors, alpha masks and the environment, for other renderers. */
#ifndef LAB_EXPORT_TEXTURES_H
#define LAB_EXPORT_TEXTURES_H

#include "base/unit.h"
#include "lab/export/target.h"

/* Writes NAME, an EXR: the factor times each texel's linear colour. */
bool export_color_texture(const struct export_target *target, int texture, vec3s factor,
                          const char *name);

/* Writes NAME, a PNG: black in the holes of the alpha mask of the base colour, else white. */
bool export_mask(const struct export_target *target, const struct material *material,
                 const char *name);

/* Writes NAME, the panorama without its strength and rotation. */
bool export_panorama(const struct export_target *target, const char *name);

/* Return n, and write the panorama with each texel n times across and down, for renderers that
 * interpolate. */
int export_panorama_repeats(const struct environment *environment);
bool export_repeated_panorama(const struct export_target *target, const char *name);

#endif
