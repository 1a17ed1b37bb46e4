/* The views that the maps of VPLs have: where each is, and what is near enough to be left out. */
#ifndef PASSES_VPL_VIEWS_H
#define PASSES_VPL_VIEWS_H

#include "passes/maps.h"

struct frame;
struct vpl_buffer;

struct vpl_views_pass {
    float near_clip; /* over the spread of VPLs */
    GLuint program;
    struct map_views views;
    struct buffer params;
};

bool vpl_views_pass_init(struct vpl_views_pass *pass, float near_clip);
void vpl_views_pass_free(struct vpl_views_pass *pass);

/* Fills pass->views with those of VPLs first .. first + count, MAP_VIEWS_MAX at most. */
void vpl_views_pass_render(struct vpl_views_pass *pass, const struct frame *frame,
                           const struct vpl_buffer *vpls, int first, int count);

#endif
