/* VPLs, their tree, and their colours. */
#ifndef SHARED_VPL_H
#define SHARED_VPL_H

#include "shared/types.h"

/* A virtual point light [Dong 2009 §4]. Transform feedback writes it (lib/vpl_output.glsl). It is
 * read as a vertex (lib/vpl_input.glsl), as texels (lib/vpl_texels.glsl) and as rows of a block
 * (lib/vpl_rows.glsl). */
#define VPL_ROWS 4

struct vpl {
    vec3 position; /* metres */
    float val;     /* C(i), index of its VAL: a whole number */
    vec3 normal;   /* unit */
    float area;    /* area that it represents, m2 */
    vec3 flux;     /* reflected, W */
    float reach;   /* reach of its near field, in spacings of its light's VPLs; 0: no hit */
    vec2 to_light; /* direction of its incoming light, octahedral */
    float alpha;   /* of its specular lobe */
    float lobe;    /* packHalf2x16: fraction of the flux in the lobe, albedo of the lobe; 0: none */
};
STD140_SIZE(vpl, 16 * VPL_ROWS)

/* Least cosine in a VPL's area, for light at grazing incidence. */
#define VPL_COSINE_MIN 0.25

/* VPLs in a uniform block: 64 KiB, which drivers allow (gl/context/needs.h). */
#define VPLS_PER_BLOCK 1024
#define VPLS_MAX 65536

/* Density of VPLs over each light's domain (lib/light_domain.glsl), from an importance map
 * (passes/lights/importance_map.h). */

/* Cells along each side of a light's domain, and mip levels from a cell to the whole domain. */
#define VPL_DENSITY_SIDE 64
#define VPL_DENSITY_LEVELS 7
#define VPL_DENSITY_ROW 8 /* domains in a row of their texture */

/* Parameters of passes/lights/vpl_tree.h. Node 1 is the root, 2 k and 2 k + 1 are the children of
 * k, and the last half are leaves. */
#define TREE_GROUP 64     /* invocations */
#define TREE_COLUMNS 1024 /* of the textures */

/* Data of a node: one layer each. */
#define TREE_LOW 0  /* lower corner of its positions; least squared reach of a near field, m2 */
#define TREE_HIGH 1 /* upper corner of its positions; least area of a VPL, m2 */
#define TREE_CONE 2 /* of normals: axis, cosine of the half angle */
#define TREE_FLUX 3 /* of all VPLs below, W; its sum over RGB, 0 without VPLs */
#define TREE_ROWS 4

struct vpl_tree_params {
    vec3 bounds_min; /* of the scene */
    int vpl_count;
    vec3 bounds_max;
    int leaves; /* a power of two, at least the count; the last are empty */
};
STD140_SIZE(vpl_tree_params, 32)

/* Colour of a VAL. */

#ifndef GL_core_profile
#include <math.h>
#endif

/* Returns channel 0 to 2, red, green, blue, of a display colour. Adjacent numbers have distant
 * hues: steps of the golden ratio. */
SHARED_FUNCTION float cluster_color(int k, int channel) {
    float turns = 0.1f + 0.61803399f * k;
    float hue = 6.0f * (turns - floor(turns)) + (channel == 0 ? 0.0f : channel == 1 ? 4.0f : 2.0f);
    float apart = hue < 6.0f ? hue - 3.0f : hue - 9.0f;
    float pure = (apart < 0.0f ? -apart : apart) - 1.0f;
    pure = pure < 0.0f ? 0.0f : pure < 1.0f ? pure : 1.0f;
    float pale = k % 2 == 0 ? 0.15f : 0.4f;
    return (pure + (1.0f - pure) * pale) * (k % 3 == 0 ? 0.8f : 1.0f);
}

#endif
