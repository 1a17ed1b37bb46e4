/* Detects scenes that are rooms seen from inside. */
#ifndef SCENE_ROOM_H
#define SCENE_ROOM_H

#include "scene/mesh/geometry.h"

/* Distances from a point to walls, metres, at most to the scene's bounds. */
struct room {
    float at[3];         /* the point */
    float up, down;      /* to the ceiling; to the floor */
    float ahead, behind; /* along the longest free horizontal line */
    float forward[3];    /* unit horizontal direction of `ahead` */
};

/* Finds the room around a point by all triangles. False: facing surfaces do not enclose the point,
 * it is inside a solid, or the room is too small a part of the scene. */
bool room_around(struct room *room, const struct geometry *geometry, const float point[3]);

/* Finds the room around the scene's centre, or around points near it if the centre is inside
 * furniture. */
bool room_find(struct room *room, const struct geometry *geometry);

#endif
