/* VPLs, and the clusters and trees made of them. */
#ifndef PASSES_VPLS_H
#define PASSES_VPLS_H

#include "gl/buffer.h"
#include "gl/pass.h"
#include "gl/texture.h"

/* N virtual point lights, struct vpl (shared/vpl.h), padded to a full uniform block. `sums` over
 * them give their spacing, the scale of lit surfaces, and their hue. */
struct vpl_buffer {
    struct buffer buffer; /* texel buffer: lib/vpl_texels.glsl */
    GLuint vertices;      /* vertex array: position 0, normal 1, flux 2 */
    int count;
    struct texture sums; /* one pixel, RGBA32F: lib/vpl_sums.glsl */
    GLuint sums_framebuffer;
};

/* Importance of VPLs in clustering (passes/lights/cluster_means.comp). values: each VPL's
 * contribution to the picture, R32F. sum: one pixel, RGBA32F, sum of all values and their
 * number. */
struct vpl_weights {
    struct texture values, sum;
};

/* Importance of VPLs (passes/lights/importance_map.h). Each light's domain is a tile of
 * VPL_DENSITY_SIDE^2 cells.
 * values: sum and number of candidates in each cell, RG32F; mip levels have means.
 * lights: a texel a light, RGBA32F: its VPLs over its VPLs by flux; cumulative fraction of VPLs;
 * cumulative fraction by flux alone.
 * densities: VPLs of each cell over VPLs by flux alone, R32F. */
struct importance_map {
    struct texture values, lights, densities;
};

/* Textures that light rays read: the scene's BVH, its triangles' albedos, and the directions of an
 * environment (0: none). */
struct light_rays {
    GLuint tree, albedos, sky_pieces;
};

void light_rays_add(struct pass_state *state, const struct light_rays *rays);

/* Binary tree over VPLs (shared/vpl.h). representatives: R32UI, the VPL of each node, one layer a
 * set of pixels. */
struct vpl_tree {
    struct texture nodes, representatives;
    GLuint vpls; /* buffer texture of the tree's VPLs */
    int leaves, sets;
};

/* Two cuts through a tree for each block of block x block pixels, R32UI; the second is for list
 * pixels. Each cut has one layer of node counts and one layer for each node. */
struct vpl_cuts {
    struct texture texture;
    const struct vpl_tree *tree;
    int block, adaptive_layer; /* side of a block, pixels; first layer of the second cut */
};

/* VALs, M x 1, RGBA32F: position and count, normal, flux (W). */
struct val_targets {
    struct texture position, normal, flux;
};

/* Binds the textures of passes/lights/vpl_by_importance.glsl. */
void importance_map_add(struct pass_state *state, const struct importance_map *map);

bool vpl_buffer_init(struct vpl_buffer *vpls, const char *label, int count);
void vpl_buffer_free(struct vpl_buffer *vpls);

/* Copies the sums of the VPLs that `vpls` replaces. */
void vpl_buffer_take_sums(const struct vpl_buffer *vpls, const struct vpl_buffer *from);

#endif
