/* The scene's lights and their views: one of a spot or directional light, six of a point light.
 * Views have arrays of maps, one layer each: one array of single views, and one of faces with half
 * the size. */
#ifndef SHARED_LIGHT_H
#define SHARED_LIGHT_H

#include "shared/view.h"

#define LIGHTS_MAX 64
#define LIGHT_VIEWS_MAX 384 /* six a light: the block then has 63 KiB */

/* Kinds of views and of arrays of maps. Single views come first. */
#define LIGHT_MAP_SINGLE 0
#define LIGHT_MAP_FACE 1
#define LIGHT_MAP_KINDS 2

#define LIGHT_TYPE_SPOT 0
#define LIGHT_TYPE_POINT 1
#define LIGHT_TYPE_DIRECTIONAL 2
#define LIGHT_TYPE_AREA 3
#define LIGHT_TYPE_MANY 4 /* all sampled lights, without views */

#define LIGHT_SHAPE_POINT 0
#define LIGHT_SHAPE_RECTANGLE 1
#define LIGHT_SHAPE_DISK 2
#define LIGHT_SHAPE_SPHERE 3
#define LIGHT_SHAPE_CAP 4
#define LIGHT_SHAPE_TRIANGLE 5 /* of sampled lights alone */

#define LIGHT_ROWS 9

struct light {
    vec3 intensity; /* W/sr; of a directional light W/m2 */
    float measure;  /* of its domain: solid angle, sr; of a directional light area, m2 */
    vec3 position;
    int type;       /* LIGHT_TYPE_... */
    vec3 direction; /* orthonormal with right and up */
    int first_view;
    vec3 right;
    float cos_inner;
    vec3 up;
    float cos_outer;
    vec3 radiance; /* of a white surface, for irradiance over intensity of 1 / direct_scale */
    /* Squared scene radius, m2: keeps numbers independent of the scene's units. */
    float direct_scale;
    int view_count;
    int shape;           /* LIGHT_SHAPE_... */
    float width, height; /* as in struct emitter */
    float extent;   /* area of the shape, m2; of a cap solid angle, sr; of many lights flux, W */
    int first_map;  /* of its own maps: one, or six of a point light (visibility/light_map.glsl) */
    float map_unit; /* distance of depth 1 in them, metres */
    float range_inverse2;            /* 1/m2; 0: unbounded */
    int slide;                       /* layer of the slides; -1: none */
    float slide_scale;               /* emitter_slide_scale; 0: a profile */
    float slide_width, slide_height; /* texels */
};
STD140_SIZE(light, 16 * LIGHT_ROWS)

#define LIGHT_VIEW_ROWS 9

struct light_view {
    STRUCT(view) view;
    int light;
    int kind;  /* LIGHT_MAP_... */
    int layer; /* layer in its kind's maps */
    int unused;
};
STD140_SIZE(light_view, 16 * LIGHT_VIEW_ROWS)

/* Block of lib/light.glsl. */
struct light_block {
    STRUCT(light) sources[LIGHTS_MAX];
    STRUCT(light_view) views[LIGHT_VIEWS_MAX];
    int count, single_count, face_count;
    int unused;
};
STD140_SIZE(light_block, 16 * (LIGHTS_MAX * LIGHT_ROWS + LIGHT_VIEWS_MAX * LIGHT_VIEW_ROWS + 1))

#endif
