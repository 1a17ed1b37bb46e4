/* Linearly transformed cosines of the specular lobe [Heitz et al. 2016]: for each roughness and view the
 * matrix that makes a cosine of it. Lights of
 * a width come out within 1 % up to a roughness of .5, but at grazing angles: 10 % there, and 30 % where it is .75. */
#ifndef SCENE_GPU_LOBES_H
#define SCENE_GPU_LOBES_H

#include "gl/texture.h"

/* For UNIT_LOBES, as lib/lobe.glsl reads it. Error: out of GPU memory. */
bool lobes_init(struct texture *lobes);

/* The lobe's directional albedo for UNIT_LOBE_ALBEDOS, as lib/lobe_albedo.glsl reads it. Error: the same. */
bool lobe_albedos_init(struct texture *albedos);

#endif
