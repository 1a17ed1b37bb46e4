/* The directional albedo of the specular lobe: the fraction of even light that it reflects towards a direction, and by
 * reciprocity of light from that direction that it reflects at all. It counts light that microfacets reflect once, as
 * glTF's lobe does; a rough white metal loses the rest. The table errs by .003 at most where f0 is .04, by .006 else, and by
 * .01 below a cosine of .035. */
#ifndef SCENE_LOBE_ALBEDO_H
#define SCENE_LOBE_ALBEDO_H

#include "shared/brdf.h"

#include <stdint.h>

/* cosine: between normal and direction. alpha: roughness^2. */
float lobe_albedo(float f0, float f90, float alpha, float cosine);

/* Its mean over even light. */
float lobe_mean_albedo(float f0, float f90, float roughness);

/* The table as lib/lobe_albedo.glsl reads it: a lobe that reflects all, and one that reflects (1 - v.h)^5; 65535 is 1. */
void lobe_albedo_texels(uint16_t texels[BRDF_ALBEDO_SIZE * BRDF_ALBEDO_SIZE][2]);

#endif
