/* One depth map for each VPL, for techniques that differ in how maps are rendered.
 *
 * Maps are rendered in batches, so that N is bounded by time and not by memory. The last batch is
 * kept. If it holds all maps, they are reused while only the camera moves. */
#ifndef TECHNIQUES_VPL_MAPS_H
#define TECHNIQUES_VPL_MAPS_H

#include "passes/visibility/paraboloid.h"
#include "passes/visibility/vpl_views.h"
#include "techniques/many_lights.h"

struct vpl_maps_desc {
    const struct depth_maps *maps; /* maps of a batch */
    /* Renders the first views->count maps, for VPLs from `first` on. */
    void (*render)(void *state, const struct frame *frame, const struct map_views *views,
                   int first);
    void *state;
};

struct vpl_maps {
    struct vpl_maps_desc desc;
    struct vpl_views_pass views;
    const struct vpl_buffer *held; /* VPLs whose maps are held, from held_first on; NULL: none */
    int held_first;
};

bool vpl_maps_init(struct vpl_maps *maps, const struct vpl_maps_desc *desc);

/* Prepares maps of every triangle, `batch` at once, as a baseline. The caller owns `paraboloid` and
 * frees it, also after an error. */
bool vpl_maps_init_true(struct vpl_maps *maps, struct paraboloid_pass *paraboloid,
                        const struct technique_desc *desc, int batch);
void vpl_maps_free(struct vpl_maps *maps);

/* Renders RSM and VPLs of all bounces, and drops the held maps. */
void vpl_maps_render_vpls(struct vpl_maps *maps, struct many_lights *lights,
                          const struct frame *frame);

/* Implements technique->render_lights: as vpl_maps_render_vpls, plus the VPLs' maps if one batch
 * holds all. */
void vpl_maps_render_lights(struct vpl_maps *maps, struct many_lights *lights,
                            const struct frame *frame);

/* Renders the next batch, for VPLs from `first` on. Returns the number of maps; 0 after the
 * last. */
int vpl_maps_render_batch(struct vpl_maps *maps, const struct frame *frame,
                          const struct vpl_buffer *vpls, int first);

/* Returns the inputs of lookups in the held maps. */
struct visibility_inputs vpl_maps_inputs(const struct vpl_maps *maps);

/* Drops the held maps, because their VPLs have changed. */
void vpl_maps_drop(struct vpl_maps *maps);

/* Gathers the light of `vpls`, batch by batch. */
void vpl_maps_gather(struct vpl_maps *maps, struct many_lights *lights,
                     const struct vpl_buffer *vpls, bool later, const struct frame *frame,
                     const struct gbuffer *gbuffer);

/* Implements technique->render_view. */
void vpl_maps_render_view(struct vpl_maps *maps, struct many_lights *lights,
                          const struct frame *frame, const struct gbuffer *gbuffer);

#endif
