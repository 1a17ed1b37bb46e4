/* Outputs as layers of a file, of the picture's size: --aov. */
#ifndef INSPECT_AOV_H
#define INSPECT_AOV_H

#include "renderer/renderer.h"

/* Whether the renderer has outputs of these names, "val,visibility", that can be layers; NULL = none
 * are wanted. Error: the first that it has not, and which there are. */
bool aov_check(const struct renderer *renderer, const char *names);

/* Adds those layers, NAME.R and so on, to the ones of the last frame (renderer_read_layers); a name
 * given twice counts once. Error: out of GPU memory, or the check's.
 *
 * irradiance: of a white surface, as the indirect layer. vpl: flux of the VPLs that a pixel shows,
 * W. val: the colour of the VAL that lights the pixel most. visibility: the share of the VALs' light
 * that arrives. ao: of cosine-weighted rays, the fraction that meets nothing near, by voxels. */
bool aov_append(struct renderer *renderer, const char *names, struct image *image);

#endif
