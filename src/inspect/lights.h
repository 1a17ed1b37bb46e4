/* Reads back the virtual lights of a renderer's last frame. */
#ifndef INSPECT_LIGHTS_H
#define INSPECT_LIGHTS_H

#include "renderer/renderer.h"

struct vpl;

struct lights {
    struct vpl *vpls;
    int vpl_count, lit;  /* lit: VPLs on a surface */
    float (*centers)[4]; /* centres of VALs; the fourth number is above 0 for VALs with VPLs */
    int val_count, used; /* 0: no VALs; used: VALs with a lit VPL */
    int area_count, area_used; /* number and used number of area lights of clusters */
};

/* Reads VPLs and VALs. Error: names a technique without VPLs; the lights are then zeroed. */
bool lights_read(struct lights *lights, struct renderer *renderer);
void lights_free(struct lights *lights);

/* Reads all VPLs of a buffer. The caller frees them. */
struct vpl *vpls_read(const struct vpl_buffer *vpls);

#endif
