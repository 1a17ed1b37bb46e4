/* What a surface that was clicked is, and which VALs light it. */
#ifndef INSPECT_PROBE_H
#define INSPECT_PROBE_H

#include "inspect/lookup.h"
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

/* What asks; zeroed at first. */
struct probe {
    struct lookup lookup;
    struct texture lit; /* M x 1 */
    GLuint framebuffer;
    struct buffer params;
};

/* Accepts a zeroed one. */
void probe_free(struct probe *probe);

/* The surface's point alone. False: there is none, or it cannot be read. */
bool probe_point(struct renderer *renderer, float x, float y, float point[3]);

/* At a place of the picture, 0 to 1, y down, of the last frame. Reads back, and so waits for the
 * GPU. Error: GPU memory, shader. */
bool probe_pick(struct probe *probe, struct renderer *renderer, float x, float y,
                struct pick *pick);

/* The VAL whose centre is nearest to a place of the picture, within a twentieth of its height; -1 =
 * none. */
int probe_nearest_val(struct renderer *renderer, float x, float y);

#endif
