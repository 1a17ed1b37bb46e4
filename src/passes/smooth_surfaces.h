/* Smooth surfaces (glass, mirrors) of a geometry: their buffers for shaders that trace rays
 * (src/passes/caustics/chain.glsl), and the view of a light that covers them. */
#ifndef PASSES_SMOOTH_SURFACES_H
#define PASSES_SMOOTH_SURFACES_H

#include "gl/buffer.h"
#include "gl/pass.h"
#include "scene/gpu/scene_gpu.h"
#include "shared/caustics.h"

struct smooth_surfaces {
    const struct scene *scene;
    bool has_glass;
    uint32_t *vertices; /* vertices of smooth triangles in the geometry */
    uint32_t vertex_count;
    unsigned painted; /* value of geometry->painted for `rows` and `materials` */
    struct buffer rows, corners, materials;
    const struct scene_gpu *gpu; /* scene_gpu of the last smooth_surfaces_follow */
};

/* Error: out of GPU memory. */
bool smooth_surfaces_init(struct smooth_surfaces *surfaces, const struct scene *scene,
                          const struct geometry *geometry);
void smooth_surfaces_free(struct smooth_surfaces *surfaces);

/* Updates the buffers to the geometry's current pose and its GPU copy. */
void smooth_surfaces_follow(struct smooth_surfaces *surfaces, const struct scene_gpu *gpu,
                            const struct geometry *geometry);

/* Binds the buffers for shaders. */
void smooth_surfaces_add(const struct smooth_surfaces *surfaces, struct pass_state *state);

/* Writes the centre of the surfaces' bounds, metres. vertex_count must not be 0. */
void smooth_surfaces_middle(const struct smooth_surfaces *surfaces, const struct geometry *geometry,
                            float middle[3]);

/* Fits a light's view of side x side texels to the smooth surfaces and a spot's cone. False: the
 * light does not reach them. */
bool smooth_surfaces_fit(const struct smooth_surfaces *surfaces, const struct geometry *geometry,
                         const struct emitter *light, int side, struct caustics_params *params);

#endif
