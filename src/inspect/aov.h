/* Adds layers to a file that only some users want: outputs of a technique, and layers of surfaces
 * (scene/surface_layers.h): --aov. */
#ifndef INSPECT_AOV_H
#define INSPECT_AOV_H

#include "renderer/renderer.h"
#include "scene/surface_layers.h"

/* Checks that the renderer has the named layers. names: "val,visibility"; NULL: none. Error: names
 * the first that is missing and the available ones. */
bool aov_check(const struct renderer *renderer, const char *names);

/* Returns true if some name is not a layer of surfaces: outputs of a technique are of one pass. */
bool aov_needs_pass(const char *names);

/* Checks that all names are layers of surfaces, which path tracing has too. centers: a pixel has
 * one sample, which mattes refuse. Error: names the first that is not. */
bool aov_check_surfaces(const char *names, bool centers);

/* Appends the layers, NAME.R and so on, to those of the last frame (renderer_read_layers). Repeated
 * names count once. motion: for layers of motion, else NULL. Error: out of GPU memory, or that of
 * aov_check.
 *
 * irradiance: of a white surface, as the indirect layer. vpl: flux of the VPLs at a pixel, W. val:
 * colour of the VAL that lights the pixel most. visibility: fraction of the VALs' light that
 * arrives. ao: fraction of cosine-weighted rays that meet nothing near, by voxels. */
bool aov_append(struct renderer *renderer, const char *names, const struct surface_motion *motion,
                struct image *image);

#endif
