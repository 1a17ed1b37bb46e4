/* VPLs, and what clusters and trees make of them. */
#ifndef PASSES_VPLS_H
#define PASSES_VPLS_H

#include "gl/buffer.h"
#include "gl/pass.h"
#include "gl/texture.h"

/* N virtual point lights: struct vpl (shared/vpl.h), at least as many as a uniform block has room for; and sums
 * over them, which tell how far they are apart, the scale of what is lit, and their hue. */
struct vpl_buffer {
    struct buffer buffer; /* texels: lib/vpl_texels.glsl */
    GLuint vertices;      /* vertex array: position 0, normal 1, flux 2 */
    int count;
    struct texture sums; /* a pixel, RGBA32F: lib/vpl_sums.glsl */
    GLuint sums_framebuffer;
};

/* How much VPLs count where they are clustered (passes/lights/cluster_means.comp): what each would give to the picture, R32F, a texel
 * a VPL; and a pixel of what all would, and of how many there are, RGBA32F. */
struct vpl_weights {
    struct texture values, sum;
};

/* Where VPLs matter (passes/lights/importance_map.h). Each light's domain is a tile of VPL_DENSITY_SIDE cells a side.
 * values: of candidates, sum and number in each cell, RG32F; mip levels have means.
 * lights: a texel a light, RGBA32F: its VPLs over its VPLs by flux; the fraction of VPLs up to it; that by flux alone.
 * densities: of each cell, VPLs over VPLs by flux alone, R32F. */
struct importance_map {
    struct texture values, lights, densities;
};

/* What rays of light read: the scene's tree, the albedos of its triangles, and the directions of a sky; 0: none. */
struct light_rays {
    GLuint tree, albedos, sky_pieces;
};

void light_rays_add(struct pass_state *state, const struct light_rays *rays);

/* A binary tree over VPLs (shared/vpl.h), and the VPL that stands for each node, as many times as there are sets
 * of pixels: R32UI, a layer a set. */
struct vpl_tree {
    struct texture nodes, representatives;
    GLuint vpls; /* buffer texture of the VPLs that it was made of */
    int leaves, sets;
};

/* Of each block of block x block pixels two cuts through a tree, the second for pixels of lists: R32UI, of each cut a
 * layer with the counts of nodes, and a layer for each node. */
struct vpl_cuts {
    struct texture texture;
    const struct vpl_tree *tree;
    int block, adaptive_layer; /* where the second begins */
};

/* Of clusters of VPLs, M x 1 RGBA32F: position and count, normal, flux (W). */
struct val_targets {
    struct texture position, normal, flux;
};

/* The file of the define VPL_AREA, which tells the area of a VPL at a point: by an importance map, or by flux alone. */
const char *vpl_area_file(bool by_importance);

/* Binds what passes/lights/vpl_by_importance.glsl reads. */
void importance_map_add(struct pass_state *state, const struct importance_map *map);

bool vpl_buffer_init(struct vpl_buffer *vpls, const char *label, int count);
void vpl_buffer_free(struct vpl_buffer *vpls);

/* The sums of what the VPLs stand for. */
void vpl_buffer_take_sums(const struct vpl_buffer *vpls, const struct vpl_buffer *from);

#endif
