/* Whether a scene is a room that is looked at from within. */
#ifndef SCENE_ROOM_H
#define SCENE_ROOM_H

#include "scene/mesh/geometry.h"

/* How far a point is from walls, metres. */
struct room {
    float up;            /* to the ceiling */
    float ahead, behind; /* along the longest free line that is level */
    float forward[3];    /* which way ahead is: unit, level */
};

/* False where the point is not shut in by surfaces that face it: out of doors, or within something
 * solid. Looks at every triangle. */
bool room_around(struct room *room, const struct geometry *geometry, const float point[3]);

#endif
