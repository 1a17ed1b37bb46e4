/* Whether a scene is a room that is looked at from within. */
#ifndef SCENE_ROOM_H
#define SCENE_ROOM_H

#include "scene/mesh/geometry.h"

/* How far a point is from walls, metres, and no farther than the scene's bounds. */
struct room {
    float at[3];         /* the point */
    float up, down;      /* to the ceiling, to the floor */
    float ahead, behind; /* along the longest free line that is level */
    float forward[3];    /* which way ahead is: unit, level */
};

/* False where the point is not shut in by surfaces that face it, out of doors or within something
 * solid; or where they leave free too little of the scene: the hollow of a figure is no room. Looks at
 * every triangle. */
bool room_around(struct room *room, const struct geometry *geometry, const float point[3]);

/* The same for the scene's centre, and where that is within furniture, for places about it. */
bool room_find(struct room *room, const struct geometry *geometry);

#endif
