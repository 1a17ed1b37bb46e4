/* What inspect/ shares with its shaders. */
#ifndef SHARED_INSPECT_H
#define SHARED_INSPECT_H

#include "shared/types.h"

/* inspect/inspect.h to its shaders. */
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
STD140_SIZE(inspect_params, 64)

/* inspect/marks.h to its shaders. */
struct mark_params {
    vec2 picture;        /* size, pixels */
    float size;          /* of a point or width of a line, pixels */
    float flux_scale;    /* of a usual VPL, 1/W */
    float normal_length; /* metres */
    BOOL by_cluster;     /* colour: by the VAL, not by the flux */
    int chosen;          /* VAL that stands out; -1 = none, and then all are as bright */
    BOOL only_chosen;    /* no other is drawn */
};
STD140_SIZE(mark_params, 32)

/* inspect/probe.h to its shader. */
struct probe_params {
    vec3 position; /* of a surface */
    float unused0;
    vec3 normal;
    float unused1;
};
STD140_SIZE(probe_params, 32)

/* inspect/screen.h to its shader. */
#define UNIT_LEFT_PICTURE (UNIT_OWN + 0)
#define UNIT_RIGHT_PICTURE (UNIT_OWN + 1)

struct screen_params {
    vec2 corner, size; /* of the picture in the window, pixels */
    float split;       /* where the right picture begins, over the width */
    float difference;  /* 1: of the two, in place of them */
    float unused0, unused1;
};
STD140_SIZE(screen_params, 32)

#endif
