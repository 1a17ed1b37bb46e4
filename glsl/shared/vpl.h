/* VPLs, their tree, and what tells them apart. */
#ifndef SHARED_VPL_H
#define SHARED_VPL_H

#include "shared/types.h"

/* A virtual point light [Dong 2009 §4]. Transform feedback writes it (lib/vpl_output.glsl); it is
 * read as a vertex (lib/vpl_input.glsl), as texels (lib/vpl_texels.glsl) and in a block
 * (lib/vpl_block.glsl). */
#define VPL_ROWS 4

struct vpl {
    vec3 position; /* metres */
    float val;     /* C(i), the VAL it belongs to: a whole number */
    vec3 normal;   /* unit */
    float area;    /* that it stands for, m2 */
    vec3 flux;     /* reflected, W */
    float reach;   /* of its near field, in spacings of its light's VPLs; 0 for a sample that met nothing */
    vec2 to_light; /* where its light came from, octahedral */
    float alpha;   /* of the lobe by which it mirrors its light */
    float lobe;    /* the share of the flux that this lobe has, and the lobe's albedo: packHalf2x16; 0: none */
};
STD140_SIZE(vpl, 16 * VPL_ROWS)

/* Where light grazes a surface, a VPL's area is that of this cosine. */
#define VPL_COSINE_MIN 0.25

/* VPLs per uniform block: the 64 KiB that all drivers seen allow (gl/context/needs.h). */
#define VPLS_PER_BLOCK 1024
#define VPLS_MAX 65536

/* The density of VPLs over each light's domain (lib/light_domain.glsl), as an importance map has it
 * (passes/lights/importance_map.h). */

/* Cells along each side of a light's domain, and mip levels from a cell to the whole domain. */
#define VPL_DENSITY_SIDE 64
#define VPL_DENSITY_LEVELS 7
#define VPL_DENSITY_ROW 8 /* the lights' domains are tiles of one texture, so many in a row */

/* passes/lights/vpl_tree.h to its shaders, and where nodes lie in its textures: node 1 is the root, 2 k and
 * 2 k + 1 are the children of k, and the last half of all are leaves. */
#define TREE_GROUP 64     /* invocations */
#define TREE_COLUMNS 1024 /* of textures */

/* Rows of a node: a layer each. */
#define TREE_LOW 0  /* of the box of places; the least squared reach of a near field, m2 */
#define TREE_HIGH 1 /* the same; the least area of a VPL, m2 */
#define TREE_CONE 2 /* of normals: axis, cosine of the half angle */
#define TREE_FLUX 3 /* of all VPLs below, W; its sum over RGB, 0 where there are none */
#define TREE_ROWS 4

struct vpl_tree_params {
    vec3 bounds_min; /* of the scene */
    int vpl_count;
    vec3 bounds_max;
    int leaves; /* a power of two, not below the count: the last are empty */
};
STD140_SIZE(vpl_tree_params, 32)

/* The colour by which a VAL is told from others. */

#ifndef GL_core_profile
#include <math.h>
#endif

/* Channel 0 to 2 of red, green, blue, for a display. Neighbours in number get hues far apart: steps of
 * the golden ratio. */
SHARED_FUNCTION float cluster_color(int k, int channel) {
    float turns = 0.1f + 0.61803399f * k;
    float hue = 6.0f * (turns - floor(turns)) + (channel == 0 ? 0.0f : channel == 1 ? 4.0f : 2.0f);
    float apart = hue < 6.0f ? hue - 3.0f : hue - 9.0f;
    float pure = (apart < 0.0f ? -apart : apart) - 1.0f;
    pure = pure < 0.0f ? 0.0f : pure < 1.0f ? pure : 1.0f;
    float pale = k % 2 == 0 ? 0.15f : 0.4f;
    return (pure + (1.0f - pure) * pale) * (k % 3 == 0 ? 0.8f : 1.0f);
}

/* What light that walks from surface to surface reads (passes/lights/light_walk.glsl). */

/* Up to so many bounces chance ends no walk. */
#define WALK_SURE 8

/* Where the light's own map has a VPL, its texels may lie below the surface by as much: over the scene's radius. */
#define BOUNCE_START 1e-3F

#endif
