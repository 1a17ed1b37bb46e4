/* Smooth surfaces of a geometry for shaders that trace rays (src/passes/caustics/chain.glsl), and a light's view of them. */
#ifndef PASSES_SMOOTH_SURFACES_H
#define PASSES_SMOOTH_SURFACES_H

#include "gl/buffer.h"
#include "gl/pass.h"
#include "scene/gpu/scene_gpu.h"
#include "shared/caustics.h"

struct smooth_surfaces {
    const struct scene *scene;
    bool has_glass;
    uint32_t *vertices; /* of the geometry, those of smooth triangles */
    uint32_t vertex_count;
    unsigned painted; /* of the geometry, that they are of */
    struct buffer rows, materials;
    const struct scene_gpu *gpu; /* that it last followed */
};

/* Error: out of GPU memory. */
bool smooth_surfaces_init(struct smooth_surfaces *surfaces, const struct scene *scene,
                          const struct geometry *geometry);
void smooth_surfaces_free(struct smooth_surfaces *surfaces);

/* Takes over where the geometry and its copy are now. */
void smooth_surfaces_follow(struct smooth_surfaces *surfaces, const struct scene_gpu *gpu,
                            const struct geometry *geometry);

/* Adds what the shaders read. */
void smooth_surfaces_add(const struct smooth_surfaces *surfaces, struct pass_state *state);

/* The middle of their bounds; only where there are any. */
void smooth_surfaces_middle(const struct smooth_surfaces *surfaces, const struct geometry *geometry,
                            float middle[3]);

/* Fits the view of `side` texels to the smooth surfaces, and to a spot's cone. False: the light does not reach them. */
bool smooth_surfaces_fit(const struct smooth_surfaces *surfaces, const struct geometry *geometry,
                         const struct emitter *light, int side, struct caustics_params *params);

#endif
