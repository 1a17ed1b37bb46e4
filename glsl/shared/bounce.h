/* passes/lights/bounce.h to its shaders. */
#ifndef SHARED_BOUNCE_H
#define SHARED_BOUNCE_H

#include "shared/types.h"

#define UNIT_PATH_POSITIONS (UNIT_OWN + 0)
#define UNIT_PATH_NORMALS (UNIT_OWN + 1)
#define UNIT_PATH_FLUXES (UNIT_OWN + 2)
#define UNIT_PATH_NEXT (UNIT_OWN + 3)
#define UNIT_PATH_AREAS (UNIT_OWN + 4)
#define UNIT_PATH_NUMBERS (UNIT_OWN + 5)
#define UNIT_PATH_RESULTS (UNIT_OWN + 6) /* what the pass before has of each path */

/* So many paths share their light out to each VPL: path (i, 0) leaves VPL i, and those of the other rows only light. Textures
 * of paths have a row for each. */
#define BOUNCE_ROWS 4

/* A path that starts by importance tries so many walks, and leaves their light at one place. */
#define BOUNCE_TRIES 4

/* So many VPLs share out the light of their paths among them: a multiple of what pixels take at once. */
#define BOUNCE_POOL 512

/* A path's numbers: which VPL it begins at and where it leaves its light, and then the directions of its first
 * WALK_SURE rays. */
#define BOUNCE_NUMBER_CHOICE 0
#define BOUNCE_NUMBER_RAYS 1

/* How much room a VPL has is told by so many runs of those beside it, of at most so many in all. */
#define BOUNCE_RUNS 8
#define BOUNCE_PARTNERS 2048

struct bounce_params {
    int vpls, later; /* of the first bounce; those that paths leave */
    int bounces;
    float start;  /* above a VPL of the light's own map, metres */
    float radius; /* of the scene */
    int tries; /* walks of a path, at most BOUNCE_TRIES */
    float unused0, unused1;
};
PASS_BLOCK(bounce_params, 32)

#endif
