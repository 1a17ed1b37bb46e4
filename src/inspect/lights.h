/* The virtual lights of a renderer's last frame, read back. */
#ifndef INSPECT_LIGHTS_H
#define INSPECT_LIGHTS_H

#include "renderer/renderer.h"

struct vpl;

struct lights {
    struct vpl *vpls;
    int vpl_count, lit;        /* lit: those that met something */
    float (*centers)[4];       /* of VALs; the fourth number is above 0 where one has VPLs */
    int val_count, used;       /* 0 = the technique has no VALs; used: those with a lit VPL */
    int area_count, area_used; /* the same of area lights of clusters */
};

/* Error: names the technique that has no VPLs; the lights are then zeroed. */
bool lights_read(struct lights *lights, struct renderer *renderer);
void lights_free(struct lights *lights);

/* All of one buffer; the caller frees them. */
struct vpl *vpls_read(const struct vpl_buffer *vpls);

#endif
