/* What is seen from lights and VALs, and what filters make of it. */
#ifndef PASSES_MAPS_H
#define PASSES_MAPS_H

#include "gl/buffer.h"
#include "gl/texture.h"

/* Up to MAP_VIEWS_MAX paraboloid views (shared/maps.h). */
struct map_views {
    struct buffer buffer;
    int count;
};

/* Map depth |q| / z_far of the nearest caster; 1 where there is none. D16, one layer a view. */
struct depth_maps {
    struct texture depth;
    struct texture normal; /* RG16, of the caster in the map's frame, octahedral; or none */
    GLuint framebuffer;
    int size, count;
};

/* What lights see along their own axes: linear depth over the light's map_unit, 1 where nothing is
 * (passes/visibility/light_map.glsl). R32F, one layer a map. */
struct light_maps {
    struct texture depth;
    int size, count;
};

/* Summed area tables of what filters average over maps of depth: R32UI to RGBA32UI, a border of zeros and
 * then a texel for each of the map; texel (x, y) has the sums over all before column x and row y, modulo
 * 2^32 (shared/maps.h). One layer a map, of Fourier bases several. */
struct sum_maps {
    struct texture sums;
    int size, count; /* of the maps: the texture is one texel larger */
};

/* Nearest and farthest depth in squares of a map of depth, RG32F; level l has squares of 2^(l + 1) texels,
 * the last of a row also what is left over (shared/maps.h). One layer a map. */
struct depth_bounds {
    struct texture bounds;
    int size, count; /* of the maps */
    int levels;
};

/* Fourier bases of the depth maps with MIP maps; layer g x count + k is group g (four terms) of map
 * k, whose depths its range makes the argument of (passes/visibility/series.glsl). */
struct basis_maps {
    struct texture cos, sin;     /* RGBA8, (b + 1) / 2 */
    struct texture z_cos, z_sin; /* RGBA16F */
    struct texture z;            /* R16F, one layer a map */
    struct buffer ranges;        /* struct series_range, one a map */
    int size, count, groups, terms;
};

/* R8: the visibility of map k at the centre of each block of block x block pixels, in layer k. */
struct block_visibilities {
    struct texture texture;
    GLuint framebuffer;
    int block;
};

struct depth_maps_desc {
    const char *label;
    int size, count;
    bool has_normals;
};

bool depth_maps_init(struct depth_maps *maps, const struct depth_maps_desc *desc);
void depth_maps_free(struct depth_maps *maps);

#endif
