/* Makes the paraboloid views of VPLs: origin, axis and near plane. */
#ifndef PASSES_VPL_VIEWS_H
#define PASSES_VPL_VIEWS_H

#include "passes/maps.h"

struct frame;
struct vpl_buffer;

struct vpl_views_pass {
    float near_clip; /* near plane, over the spread of VPLs */
    GLuint program;
    struct map_views views;
    struct buffer params;
};

bool vpl_views_pass_init(struct vpl_views_pass *pass, float near_clip);
void vpl_views_pass_free(struct vpl_views_pass *pass);

/* Fills pass->views for VPLs first to first + count - 1, at most MAP_VIEWS_MAX. */
void vpl_views_pass_render(struct vpl_views_pass *pass, const struct frame *frame,
                           const struct vpl_buffer *vpls, int first, int count);

#endif
