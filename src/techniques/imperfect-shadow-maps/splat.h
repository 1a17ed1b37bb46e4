/* Imperfect shadow maps: points are drawn into a small paraboloid map of each VPL [Ritschel et al. 2008].
 *
 * A point stands for a disk of its share of the area, and is drawn as such: each texel shows where its own
 * direction meets the disk's plane, and how that is tilted. Or as published, as a square of the same solid
 * angle at the distance of the point, set back by as much as its surface may come nearer within. A square shows
 * in one texel at least, so that far surfaces hide more than they should; a disk where it covers a texel's middle.
 */
#ifndef TECHNIQUES_SPLAT_H
#define TECHNIQUES_SPLAT_H

#include "passes/maps.h"
#include "techniques/imperfect-shadow-maps/caster_points.h"

struct frame;
struct map_views;

struct splat_desc {
    struct caster_points_desc points;
    int size, count; /* of the maps */
    float scale;     /* of what is drawn, over what the points stand for */
    int shape;       /* SPLAT_... */
};

struct splat_pass {
    struct splat_desc desc;
    struct caster_points points;
    GLuint program;
    struct depth_maps maps; /* with SPLAT_DISK they have normals */
    struct buffer params;
};

bool splat_pass_init(struct splat_pass *pass, const struct splat_desc *desc);
void splat_pass_free(struct splat_pass *pass);

/* The first views->count maps, which are those of VPLs first ... Timer "depth maps". */
void splat_pass_render(struct splat_pass *pass, const struct frame *frame,
                       const struct map_views *views, int first);

#endif
