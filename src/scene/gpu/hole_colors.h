/* Colours for the holes of an alpha mask: those of the opaque texels around them.
 *
 * Files often have white or black in holes. MIP levels mix it into small leaves, which turn pale or dark. Holes are filled
 * from a pyramid of means over opaque texels [Gortler et al. 1996, the pull-push algorithm].
 */
#ifndef SCENE_GPU_HOLE_COLORS_H
#define SCENE_GPU_HOLE_COLORS_H

#include "scene/scene.h"

/* A copy of the texels, RGBA, in which holes have other colours and all have the same alpha; the caller frees it. A texel
 * is a hole where its alpha is below the cutoff, in [0, 1]. */
unsigned char *hole_colors_fill(const struct bitmap *bitmap, float cutoff);

#endif
