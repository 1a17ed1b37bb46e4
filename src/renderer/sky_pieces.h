/* Directions of an environment's light samples. Each VPL takes one and follows a ray
 * (src/passes/lights/vpl_reflected.glsl).
 *
 * With one direction a group, indoor light would depend on chance. All rays of a group that pass
 * its opening have equal coordinates in the light's domain. So an importance map of the group is as
 * sharp as for one direction. Later passes have other directions. */
#ifndef RENDERER_SKY_PIECES_H
#define RENDERER_SKY_PIECES_H

#include "renderer/renderer.h"

/* Error: out of GPU memory. */
bool sky_pieces_init(struct texture *pieces);

/* Fills renderer->sky_pieces if its light samples have an environment: one row for each sample
 * (shared/sky.h), zeros for other lights. */
void sky_pieces_write(const struct renderer *renderer);

#endif
