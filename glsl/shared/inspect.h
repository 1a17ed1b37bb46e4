/* Parameters that inspect/ shares with its shaders. */
#ifndef SHARED_INSPECT_H
#define SHARED_INSPECT_H

#include "shared/types.h"

/* Parameters of inspect/inspect.h. */
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

/* Soft shadows: lit by a VAL; behind the VAL or turned away; darkest shadow. */
#define INSPECT_LIT 0.95, 0.95, 0.95
#define INSPECT_TURNED_AWAY 0.36, 0.42, 0.52
#define INSPECT_SHADOW 0.08

struct inspect_params {
    int kind; /* INSPECT_... */
    int first_layer, layer_count;
    int columns, rows; /* of a contact sheet of layers */
    float gap;         /* dark gap between cells, pixels */
    vec2 cell;         /* cell of the sheet, pixels; 0: one layer, pixel by pixel */
    vec3 center;       /* centre of the scene's bounding sphere */
    float radius;      /* metres */
    float exposure;    /* factor of irradiance */
    float unused0, unused1, unused2;
};
STD140_SIZE(inspect_params, 64)

/* Parameters of inspect/marks.h. */
struct mark_params {
    vec2 picture;        /* size, pixels */
    float size;          /* size of a point or width of a line, pixels */
    float flux_scale;    /* of a typical VPL, 1/W */
    float normal_length; /* metres */
    BOOL by_cluster;     /* colour by VAL; else by flux */
    int chosen;          /* highlighted VAL; -1: none, and all are equally bright */
    BOOL only_chosen;    /* draws only the chosen VAL */
};
STD140_SIZE(mark_params, 32)

/* Parameters of inspect/probe.h. */
struct probe_params {
    vec3 position; /* of a surface */
    float unused0;
    vec3 normal;
    float unused1;
};
STD140_SIZE(probe_params, 32)

/* Parameters of inspect/screen.h. */
#define UNIT_LEFT_PICTURE (UNIT_OWN + 0)
#define UNIT_RIGHT_PICTURE (UNIT_OWN + 1)

struct screen_params {
    vec2 corner, size; /* of the picture in the window, pixels */
    float split;       /* left edge of the right picture, over the width */
    float difference;  /* 1: shows the difference of both */
    float unused0, unused1;
};
STD140_SIZE(screen_params, 32)

#endif
