/* Imperfect shadow maps: points, and how holes between them are closed. */
#ifndef SHARED_SPLAT_H
#define SHARED_SPLAT_H

#include "shared/types.h"

/* The points of imperfect shadow maps, and how they are drawn. */
#define UNIT_CASTER_POINTS (UNIT_OWN + 0)

#define CASTER_POINT_ROWS 2

/* Stands for a disk. */
struct caster_point {
    vec3 position; /* metres */
    float radius;  /* of one of all points, metres; 0: there is none */
    vec3 normal;   /* unit */
    float unused;
};
STD140_SIZE(caster_point, 16 * CASTER_POINT_ROWS)

#define SPLAT_DISK 0
#define SPLAT_SQUARE 1

struct splat_params {
    int first; /* VPL of the first map */
    int points; /* of a map */
    int sets;   /* of so many points each, which VPLs take in turn */
    float map_size; /* texels */
    float scale;    /* radius of what is drawn, over that of the disk whose area a point stands for */
    float unused0, unused1, unused2;
};
STD140_SIZE(splat_params, 32)

/* How holes of imperfect shadow maps are closed. */
#define UNIT_COARSE_DEPTH (UNIT_OWN + 0)

/* Texels twice as wide at each; what is farther from a point than the last one's is a hole for good. */
#define FILL_LEVELS 3

struct fill_params {
    int level;      /* of the fine texels, 0 the map's own */
    float map_size; /* of level 0, texels */
    float radius;   /* of points, metres */
    float unused;
};
STD140_SIZE(fill_params, 16)

#endif
