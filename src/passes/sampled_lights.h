/* Lights without maps, on the GPU: a light tree samples them (scene/lights/light_tree.h), and rays
 * test their visibility. A frame takes them where lights are many (renderer/light_plan.h). For VPLs
 * they are one light, of EMITTER_MANY. */
#ifndef PASSES_SAMPLED_LIGHTS_H
#define PASSES_SAMPLED_LIGHTS_H

#include "gl/buffer.h"
#include "gl/pass.h"
#include "scene/lights/emitter.h"
#include "scene/mesh/geometry.h"

struct sampled_lights {
    struct buffer nodes; /* struct light_node; texels: UNIT_LIGHT_NODES */
    struct buffer
        lights;  /* struct sampled_light, in the tree's order; texels: UNIT_SAMPLED_LIGHTS */
    double flux; /* of all, W */
};

/* Uploads lights, with emissive triangles in place of stand-ins. Without any,
 * `lights` is zeroed. Error: out of GPU memory. */
bool sampled_lights_init(struct sampled_lights *lights, const struct emitters *emitters,
                         const struct scene *scene, const struct geometry *geometry);
void sampled_lights_free(struct sampled_lights *lights);

/* Binds the textures of lib/light_tree.glsl. */
void sampled_lights_add(const struct sampled_lights *lights, struct pass_state *state);

#endif
