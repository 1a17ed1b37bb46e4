/* Texture lookups on the CPU, filtered as by a GPU without mip maps. */
#ifndef SCENE_TEXTURE_H
#define SCENE_TEXTURE_H

#include "base/unit.h"
#include "scene/scene.h"

/* Fills the table of linear values of the 256 sRGB bytes. */
void texture_decode_table(float srgb_to_linear[256]);

/* Returns linear RGBA at uv; (0, 0) is the picture's top left corner. Nearest or bilinear by the
 * texture, filtered after decoding. */
vec4s texture_lookup(const struct scene_texture *texture, const float srgb_to_linear[256],
                     vec2s uv);

/* Every driver of OpenGL 4.5 takes textures up to this size. */
enum { TEXTURE_SIDE_MAX = 16384 };

/* Shrinks the texture to at most `most` texels a side, if it is larger. Each texel is the mean of
 * the texels it covers. */
void texture_shrink(struct scene_texture *texture, int most);

#endif
