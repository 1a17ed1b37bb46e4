/* Maps seen from lights and VALs, and their filtered forms. */
#ifndef PASSES_MAPS_H
#define PASSES_MAPS_H

#include "gl/buffer.h"
#include "gl/texture.h"

/* Up to MAP_VIEWS_MAX paraboloid views (shared/maps.h). */
struct map_views {
    struct buffer buffer;
    int count;
};

/* Map depth |q| / z_far of the nearest caster, D16; 1: no caster. One layer a view. */
struct depth_maps {
    struct texture depth;
    struct texture normal; /* RG16, octahedral: the caster's normal in the map's frame; or none */
    GLuint framebuffer;
    int size, count;
};

/* Depth along the light's own axes, linear, over the light's map_unit; 1: no caster
 * (passes/visibility/light_map.glsl). R32F, one layer a map. */
struct light_maps {
    struct texture depth;
    int size, count;
};

/* Summed-area tables over depth maps, R32UI to RGBA32UI (shared/maps.h). Texel (x, y) is the sum
 * over all columns before x and rows before y, modulo 2^32; the border is 0. One layer a map;
 * several for Fourier bases. */
struct sum_maps {
    struct texture sums;
    int size, count; /* of the maps; the texture is one texel larger */
};

/* Nearest and farthest depth in squares of a depth map, RG32F (shared/maps.h). Level l has squares
 * of 2^(l + 1) texels; the last of a row also covers the remainder. One layer a map. */
struct depth_bounds {
    struct texture bounds;
    int size, count; /* of the maps */
    int levels;
};

/* Fourier bases of the depth maps, with mip levels. Layer g x count + k is group g (four terms) of
 * map k. The map's range scales depth to the argument (passes/visibility/series.glsl). */
struct basis_maps {
    struct texture cos, sin;     /* RGBA8, (b + 1) / 2 */
    struct texture z_cos, z_sin; /* RGBA16F */
    struct texture z;            /* R16F, one layer a map */
    struct buffer ranges;        /* struct series_range, one a map */
    int size, count, groups, terms;
};

/* Visibility of map k at the centre of each block of block x block pixels: R8, layer k. */
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
