/* What a surface that was clicked is, and which VALs light it. */
#ifndef VIEWER_PICK_H
#define VIEWER_PICK_H

#include "renderer/renderer.h"

enum { PICK_VALS_MAX = 8 };

struct pick {
    bool present; /* a surface was hit */
    float position[3], normal[3], albedo[3];
    float radiance[3], direct[3], indirect[3]; /* the last two of a white surface */

    /* The VALs that bring most, brightest first. */
    struct pick_val {
        int val, vpl_count;
        float visibility;
        float share; /* of the irradiance of all VPLs, shadows counted */
    } vals[PICK_VALS_MAX];
    int val_count;
};

/* At a place of the picture, 0 to 1, y down, of the last frame. Reads back, and so waits for the
 * GPU. Error: GPU memory, shader. */
bool pick_at(struct pick *pick, struct renderer *renderer, float x, float y);

/* The VAL whose centre is nearest to a place of the picture, within a twentieth of its height; -1 =
 * none. */
int pick_nearest_val(struct renderer *renderer, float x, float y);

#endif
