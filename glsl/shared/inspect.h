/* inspect/inspect.h to its shaders. */
#ifndef SHARED_INSPECT_H
#define SHARED_INSPECT_H

#include "shared/types.h"

#define UNIT_INSPECTED_LAYERS (UNIT_OWN + 0)
#define UNIT_INSPECTED_PLANE (UNIT_OWN + 1)

#define INSPECT_NORMAL 0
#define INSPECT_ALBEDO 1
#define INSPECT_DEPTH 2
#define INSPECT_SINGLE_DEPTH 3
#define INSPECT_FACE_DEPTH 4
#define INSPECT_MAP_DEPTH 5
#define INSPECT_BASIS 6
#define INSPECT_SIGNED_BASIS 7
#define INSPECT_IRRADIANCE 8
#define INSPECT_DIMMED 9
#define INSPECT_VISIBILITY 10

/* Soft shadows: what a VAL lights, cannot light as it lies behind it or is turned away, and how dark its shadow is. */
#define INSPECT_LIT 0.95, 0.95, 0.95
#define INSPECT_TURNED_AWAY 0.36, 0.42, 0.52
#define INSPECT_SHADOW 0.08

struct inspect_params {
    int kind; /* what is shown, INSPECT_... */
    int first_layer, layer_count;
    int columns, rows; /* layers shown at once, as a sheet */
    float gap;         /* dark between cells, pixels */
    vec2 cell;         /* of the sheet, pixels; 0: one layer, pixel by pixel */
    vec3 center;       /* of the scene's bounding sphere */
    float radius;      /* metres */
    float exposure;    /* factor on irradiance */
    float unused0, unused1, unused2;
};
PASS_BLOCK(inspect_params, 64)

#endif
