/* Directions of a sky's light samples, of which each VPL takes one, and follows a ray (src/passes/lights/sky_ray.glsl).
 *
 * Were a group one direction, its light in a room would be luck: by day a hall under a skylight had 16 to 36 % too much with
 * one of three seeds. Rays of a group lie so that all that pass its door have the same place in the light's domain:
 * an importance map of the group is then as sharp as of one direction. Passes after the first have other directions.
 */
#ifndef RENDERER_SKY_PIECES_H
#define RENDERER_SKY_PIECES_H

#include "renderer/renderer.h"

/* Error: out of GPU memory. */
bool sky_pieces_init(struct texture *pieces);

/* Into renderer->sky_pieces, where its light samples have a sky: a row of each (shared/sky.h), zeros of other lights. */
void sky_pieces_write(const struct renderer *renderer);

#endif
