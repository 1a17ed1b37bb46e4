/* Parameters of imperfect shadow maps: points, and hole filling. */
#ifndef SHARED_SPLAT_H
#define SHARED_SPLAT_H

#include "shared/types.h"

/* Points of imperfect shadow maps. */
#define UNIT_CASTER_POINTS (UNIT_OWN + 0)

#define CASTER_POINT_ROWS 2

/* A point represents a disk. */
struct caster_point {
    vec3 position; /* metres */
    float radius;  /* radius if all points had equal area, metres; 0: no point */
    vec3 normal;   /* unit */
    float unused;
};
STD140_SIZE(caster_point, 16 * CASTER_POINT_ROWS)

#define SPLAT_DISK 0
#define SPLAT_SQUARE 1

struct splat_params {
    int first;      /* VPL of the first map */
    int points;     /* points of a map */
    int sets;       /* sets of `points` points, which VPLs use in turn */
    float map_size; /* texels */
    float scale;    /* drawn radius over the radius of the point's disk */
    float unused0, unused1, unused2;
};
STD140_SIZE(splat_params, 32)

/* Filling of holes. */
#define UNIT_COARSE_DEPTH (UNIT_OWN + 0)

/* Levels, each with twice the texel size. Texels farther from a point than the last level stay
 * holes. */
#define FILL_LEVELS 3

struct fill_params {
    int level;      /* level of the fine texels; 0: the map's own */
    float map_size; /* of level 0, texels */
    float radius;   /* radius of a point, metres */
    float unused;
};
STD140_SIZE(fill_params, 16)

#endif
