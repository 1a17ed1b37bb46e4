/* Reads the surface at a clicked pixel and the VALs that light it. */
#ifndef INSPECT_PROBE_H
#define INSPECT_PROBE_H

#include "inspect/lookup.h"
#include "renderer/renderer.h"

enum { PICK_VALS_MAX = 8 };

struct pick {
    bool present; /* true: a surface is there */
    float position[3], normal[3], albedo[3];
    /* W/(sr m2); direct and indirect of a white surface. */
    float radiance[3], direct[3], indirect[3];

    /* VALs that contribute most, brightest first. */
    struct pick_val {
        int val, vpl_count;
        float visibility;
        float share; /* fraction of the irradiance of all VPLs, with shadows */
    } vals[PICK_VALS_MAX];
    int val_count;
};

/* Resources of a probe; zeroed at first. */
struct probe {
    struct lookup lookup;
    struct texture lit; /* M x 1, visibility of each VAL */
    GLuint framebuffer;
    struct buffer params;
};

/* Accepts a zeroed probe. */
void probe_free(struct probe *probe);

/* Finds the point of the surface at a picture position, in [0, 1]^2, y down. Returns false if there
 * is no surface or it cannot be read. */
bool probe_point(struct renderer *renderer, float x, float y, float point[3]);

/* Reads the surface at a picture position of the last frame, in [0, 1]^2, y down. Waits for the
 * GPU. Error: GPU memory, shader. */
bool probe_pick(struct probe *probe, struct renderer *renderer, float x, float y,
                struct pick *pick);

/* Returns the VAL whose centre is nearest to a picture position, within a twentieth of the height;
 * -1: none. */
int probe_nearest_val(struct renderer *renderer, float x, float y);

#endif
