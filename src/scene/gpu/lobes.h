/* Linearly transformed cosines of the specular lobe [Heitz et al. 2016]: a matrix for each
 * roughness and view direction. Errors for wide lights are within 1 % up to roughness .5. At
 * grazing angles they reach 10 %, and 30 % at roughness .75. Where only the lobe's tails see a
 * light they are larger: 18 degrees above a surface of roughness .4, what lies 20 degrees beside
 * the mirrored ray gets 36 % of its light (docs/notes/materials.md). */
#ifndef SCENE_GPU_LOBES_H
#define SCENE_GPU_LOBES_H

#include "gl/texture.h"

/* Makes the texture for UNIT_LOBES (lib/lobe.glsl). Error: out of GPU memory. */
bool lobes_init(struct texture *lobes);

/* Makes the lobe's directional albedo for UNIT_LOBE_ALBEDOS (lib/lobe_albedo.glsl). Error: out of
 * GPU memory. */
bool lobe_albedos_init(struct texture *albedos);

#endif
