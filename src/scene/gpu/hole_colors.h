/* Fills the holes of an alpha mask with the colours of opaque texels around them.
 *
 * Files often have white or black in holes, which mip levels mix into small leaves. Holes are
 * filled from a pyramid of means over opaque texels [Gortler et al. 1996, the pull-push
 * algorithm]. */
#ifndef SCENE_GPU_HOLE_COLORS_H
#define SCENE_GPU_HOLE_COLORS_H

#include "scene/scene.h"

/* Returns an RGBA copy with filled holes and constant alpha. The caller frees it. A texel with
 * alpha below the cutoff, in [0, 1], is a hole. */
unsigned char *hole_colors_fill(const struct bitmap *bitmap, float cutoff);

#endif
