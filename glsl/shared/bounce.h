/* Parameters of passes/lights/bounce.h. */
#ifndef SHARED_BOUNCE_H
#define SHARED_BOUNCE_H

#include "shared/types.h"

#define UNIT_PATH_POSITIONS (UNIT_OWN + 0)
#define UNIT_PATH_NORMALS (UNIT_OWN + 1)
#define UNIT_PATH_FLUXES (UNIT_OWN + 2)
#define UNIT_PATH_NEXT (UNIT_OWN + 3)
#define UNIT_PATH_AREAS (UNIT_OWN + 4)
#define UNIT_PATH_NUMBERS (UNIT_OWN + 5)
#define UNIT_PATH_RESULTS (UNIT_OWN + 6) /* results of the previous pass, one texel a path */

/* Paths that share their light with each VPL, and rows of path textures. Path (i, 0) leaves VPL i;
 * paths of other rows leave only light. */
#define BOUNCE_ROWS 4

/* Walks that a path by importance tries; it leaves their light at one place. */
#define BOUNCE_TRIES 4

/* VPLs in a pool that share the light of their paths: a multiple of the VPLs of a pixel. */
#define BOUNCE_POOL 512

/* A path's numbers: choice of its VPL and of its end, then the directions of its first WALK_SURE
 * rays. */
#define BOUNCE_NUMBER_CHOICE 0
#define BOUNCE_NUMBER_RAYS 1

/* Runs of neighbouring VPLs from which a VPL's area is estimated, and most VPLs in all runs. */
#define BOUNCE_RUNS 8
#define BOUNCE_PARTNERS 2048

struct bounce_params {
    int vpls, later; /* VPLs of the first bounce; VPLs that paths leave */
    int bounces;
    float start;  /* offset above a VPL of the light's RSM, metres */
    float radius; /* scene radius, metres */
    int tries;    /* walks of a path, at most BOUNCE_TRIES */
    float unused0, unused1;
};
PASS_BLOCK(bounce_params, 32)

#endif
