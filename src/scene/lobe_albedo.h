/* Directional albedo of the specular lobe: the fraction of uniform light reflected towards a
 * direction, or by reciprocity of light from it. Only single scattering counts, as in glTF's lobe;
 * a rough white metal loses the rest. Error at most .003 for f0 = .04, .006 else, .01 below a
 * cosine of .035. */
#ifndef SCENE_LOBE_ALBEDO_H
#define SCENE_LOBE_ALBEDO_H

#include "shared/brdf.h"

#include <stdint.h>

/* Returns the albedo. cosine: between normal and direction. alpha: roughness^2. */
float lobe_albedo(float f0, float f90, float alpha, float cosine);

/* Returns the albedo's mean over uniform light. */
float lobe_mean_albedo(float f0, float f90, float roughness);

/* Writes the table of lib/lobe_albedo.glsl: lobe of reflectance 1; lobe of (1 - v.h)^5. 65535 is
 * 1. */
void lobe_albedo_texels(uint16_t texels[BRDF_ALBEDO_SIZE * BRDF_ALBEDO_SIZE][2]);

#endif
