/* A map for each VPL: what techniques share that have one. They differ in how maps are made.
 *
 * Maps are made in batches, so that N is bounded by time and not by memory. The last batch stays: where
 * it is all of them, and only the camera moves, they need not be made again.
 */
#ifndef TECHNIQUES_VPL_MAPS_H
#define TECHNIQUES_VPL_MAPS_H

#include "passes/visibility/paraboloid.h"
#include "passes/visibility/vpl_views.h"
#include "techniques/many_lights.h"

struct vpl_maps_desc {
    const struct depth_maps *maps; /* of a batch */
    /* Fills the first views->count maps, which are those of VPLs first .. */
    void (*render)(void *state, const struct frame *frame, const struct map_views *views,
                   int first);
    void *state;
};

struct vpl_maps {
    struct vpl_maps_desc desc;
    struct vpl_views_pass views;
    const struct vpl_buffer *held; /* whose maps are there, from held_first on; NULL: none are */
    int held_first;
};

bool vpl_maps_init(struct vpl_maps *maps, const struct vpl_maps_desc *desc);

/* Maps of every triangle, `batch` at once: for what is to be the plain reference. The pass that draws them is the
 * caller's, to be freed whatever comes of it. */
bool vpl_maps_init_true(struct vpl_maps *maps, struct paraboloid_pass *paraboloid,
                        const struct technique_desc *desc, int batch);
void vpl_maps_free(struct vpl_maps *maps);

/* RSM and VPLs of all bounces; no maps are held then. */
void vpl_maps_render_vpls(struct vpl_maps *maps, struct many_lights *lights,
                          const struct frame *frame);

/* As technique->render_lights: the same, and the VPLs' maps, where one batch is all. */
void vpl_maps_render_lights(struct vpl_maps *maps, struct many_lights *lights,
                            const struct frame *frame);

/* Makes the maps of VPLs first .. of the next batch. Returns how many they are; 0 after the last. */
int vpl_maps_render_batch(struct vpl_maps *maps, const struct frame *frame,
                          const struct vpl_buffer *vpls, int first);

/* What is looked up then. */
struct visibility_inputs vpl_maps_inputs(const struct vpl_maps *maps);

/* For VPLs that have changed: none is held. */
void vpl_maps_drop(struct vpl_maps *maps);

/* Gathers the light of such VPLs, batch by batch. */
void vpl_maps_gather(struct vpl_maps *maps, struct many_lights *lights,
                     const struct vpl_buffer *vpls, bool later, const struct frame *frame,
                     const struct gbuffer *gbuffer);

/* As technique->render_view. */
void vpl_maps_render_view(struct vpl_maps *maps, struct many_lights *lights,
                          const struct frame *frame, const struct gbuffer *gbuffer);

#endif
