#include "passes/sampled_lights.h"

#include "base/memory.h"
#include "scene/lights/light_tree.h"
#include "shared/bindings.h"
#include "shared/light_tree.h"
#include "shared/sampled_light.h"

#include <cglm/cglm.h>
#include <stdlib.h>

static struct sampled_light light_of(const struct emitter *emitter) {
    struct sampled_light light = {
        .type = emitter->type,
        .cos_inner = emitter->cos_inner,
        .cos_outer = emitter->cos_outer,
        .width = emitter->size[0],
        .height = emitter->size[1],
        .shape = (int)emitter_shape(emitter),
        .range_inverse2 =
            emitter->range > 0 ? fminf(1 / (emitter->range * emitter->range), 1e30F) : 0,
        .slide = -1,
    };
    glm_vec3_copy((float *)emitter->intensity, light.intensity);
    glm_vec3_copy((float *)emitter->position, light.position);
    glm_vec3_copy((float *)emitter->direction, light.direction);
    glm_vec3_copy((float *)emitter->right, light.right);
    glm_vec3_copy((float *)emitter->up, light.up);
    if (emitter->slide && emitter->type == EMITTER_SPOT) {
        light.slide = emitter->slide->layer;
        light.slide_scale = emitter_slide_scale(emitter);
        light.slide_width = (float)emitter->slide->width;
        light.slide_height = (float)emitter->slide->height;
    }
    return light;
}

/* Lights in the order of the tree's leaves, which lie near each other. */
struct ordered {
    struct light_node *nodes;
    const struct emitter *emitters;
    struct sampled_light *lights;
    int count;
    double flux;
};

static void order_below(struct ordered *ordered, int node) {
    int link = ordered->nodes[node].link;
    if (link >= 0) {
        order_below(ordered, link);
        order_below(ordered, link + 1);
        return;
    }
    const struct emitter *emitter = &ordered->emitters[-1 - link];
    struct sampled_light *light = &ordered->lights[ordered->count];
    double flux = emitter_flux(emitter, 1);
    *light = light_of(emitter);
    light->flux_before = (float)ordered->flux;
    light->flux = (float)flux;
    ordered->nodes[node].link = -1 - ordered->count++;
    ordered->flux += flux;
}

static void build_tree(struct light_tree *tree, const struct emitter *lights, int count) {
    struct light_bounds *bounds = mem_alloc((size_t)count, sizeof *bounds);
    for (int i = 0; i < count; i++)
        bounds[i] = light_bounds_of(&lights[i]);
    light_tree_init(tree, bounds, count);
    free(bounds);
}

bool sampled_lights_init(struct sampled_lights *lights, const struct emitters *emitters) {
    *lights = (struct sampled_lights){0};
    struct light_tree tree;
    struct ordered ordered = {.emitters = emitters->items + emitters->count};
    if (emitters->sampled == 0)
        return true;
    build_tree(&tree, ordered.emitters, emitters->sampled);
    ordered.nodes = tree.nodes;
    ordered.lights = mem_alloc((size_t)emitters->sampled, sizeof *ordered.lights);
    if (tree.node_count > 0)
        order_below(&ordered, 0);
    for (int i = 0; i < ordered.count; i++) {
        ordered.lights[i].flux_before /= (float)ordered.flux;
        ordered.lights[i].flux /= (float)ordered.flux;
    }
    lights->flux = ordered.flux;
    bool ok = buffer_init_texels(&lights->nodes, GL_RGBA32F, "light tree",
                                 (size_t)tree.node_count * sizeof *tree.nodes, tree.nodes) &&
              buffer_init_texels(&lights->lights, GL_RGBA32F, "sampled lights",
                                 (size_t)ordered.count * sizeof *ordered.lights, ordered.lights);
    free(ordered.lights);
    light_tree_free(&tree);
    if (!ok)
        sampled_lights_free(lights);
    return ok;
}

void sampled_lights_free(struct sampled_lights *lights) {
    buffers_free(&lights->nodes, &lights->lights);
    *lights = (struct sampled_lights){0};
}

void sampled_lights_add(const struct sampled_lights *lights, struct pass_state *state) {
    if (!lights->nodes.texels)
        return;
    pass_add_texture(state, UNIT_LIGHT_NODES, lights->nodes.texels);
    pass_add_texture(state, UNIT_SAMPLED_LIGHTS, lights->lights.texels);
}
