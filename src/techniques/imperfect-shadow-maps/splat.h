/* Draws imperfect shadow maps: points in a small paraboloid map of each VPL [Ritschel et al. 2008].
 *
 * A point is drawn as a disk of its area: each texel has the depth and the tilt where its direction
 * meets the disk's plane. The published variant draws a square of the same solid angle at the
 * point's distance. It is set back by the depth that its surface may span. A square covers at least
 * one texel, so distant surfaces hide too much; a disk covers texel centres only. */
#ifndef TECHNIQUES_SPLAT_H
#define TECHNIQUES_SPLAT_H

#include "passes/maps.h"
#include "techniques/imperfect-shadow-maps/caster_points.h"

struct frame;
struct map_views;

struct splat_desc {
    struct caster_points_desc points;
    int size, count; /* side of a map, texels; number of maps */
    float scale;     /* drawn size over the point's size */
    int shape;       /* SPLAT_... */
};

struct splat_pass {
    struct splat_desc desc;
    struct caster_points points;
    GLuint program;
    struct depth_maps maps; /* have normals with SPLAT_DISK */
    struct buffer params;
};

bool splat_pass_init(struct splat_pass *pass, const struct splat_desc *desc);
void splat_pass_free(struct splat_pass *pass);

/* Draws the first views->count maps, for VPLs from `first` on. Timer "depth maps". */
void splat_pass_render(struct splat_pass *pass, const struct frame *frame,
                       const struct map_views *views, int first);

#endif
