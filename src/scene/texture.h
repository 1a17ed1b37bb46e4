/* One texel or four of a material's texture, as a GPU without MIP maps would filter them. */
#ifndef SCENE_TEXTURE_H
#define SCENE_TEXTURE_H

#include "base/unit.h"
#include "scene/scene.h"

/* What the 256 values of a byte of a colour are worth. */
void texture_decode_table(float srgb_to_linear[256]);

/* Linear RGBA at uv; (0, 0) is the top left corner of the picture. Nearest or bilinear as the
 * texture asks for, filtered after decoding. */
vec4s texture_lookup(const struct scene_texture *texture, const float srgb_to_linear[256],
                     vec2s uv);

/* Makes no side longer than so many texels. Each texel becomes the mean of the texels that it covers. */
void texture_shrink(struct scene_texture *texture, int most);

#endif
