/* One texel or four of a material's texture, as a GPU without MIP maps would filter them. */
#ifndef REFERENCE_SCENE_TEXTURE_H
#define REFERENCE_SCENE_TEXTURE_H

#include "scene/scene.h"

#include <cglm/struct.h>

/* Linear RGBA at uv; (0, 0) is the top left corner of the picture. Nearest or bilinear as the
 * texture asks for, filtered after decoding. srgb_to_linear decodes the 256 values of a byte of
 * a colour. */
vec4s texture_lookup(const struct scene_texture *texture, const float srgb_to_linear[256],
                     vec2s uv);

#endif
