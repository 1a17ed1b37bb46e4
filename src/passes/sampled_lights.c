#include "passes/sampled_lights.h"

#include "base/memory.h"
#include "base/unit.h"
#include "scene/lights/emissive_triangles.h"
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
    if (emitter_has_slide(emitter)) {
        light.slide = emitter->slide->layer;
        light.slide_scale = emitter_slide_scale(emitter);
        light.slide_width = (float)emitter->slide->width;
        light.slide_height = (float)emitter->slide->height;
    }
    return light;
}

/* A triangle emits from its front: intensity is its area times its radiance. */
static struct sampled_light light_of_triangle(const struct light_triangle *triangle) {
    struct sampled_light light = {.type = EMITTER_AREA, .shape = LIGHT_SHAPE_TRIANGLE, .slide = -1};
    vec3 across;
    glm_vec3_cross((float *)triangle->edge_1, (float *)triangle->edge_2, across);
    float area = glm_vec3_norm(across) / 2;
    glm_vec3_scale((vec3){triangle->red, triangle->green, triangle->blue}, area, light.intensity);
    glm_vec3_copy((float *)triangle->corner, light.position);
    vec3_unit_to(across, light.direction);
    glm_vec3_copy((float *)triangle->edge_1, light.right);
    glm_vec3_copy((float *)triangle->edge_2, light.up);
    return light;
}

/* Lights with their bounds, while their tree is built. */
struct list {
    struct sampled_light *lights;
    struct light_bounds *bounds;
    int count;
};

static void list_add(struct list *list, const struct sampled_light *light,
                     const struct light_bounds *bounds, double flux) {
    list->lights[list->count] = *light;
    list->lights[list->count].flux = (float)flux;
    list->bounds[list->count++] = *bounds;
}

static void list_triangles(struct list *list, const struct emissive_triangles *triangles) {
    for (int i = 0; i < triangles->count; i++) {
        const struct light_triangle *triangle = &triangles->items[i];
        struct sampled_light light = light_of_triangle(triangle);
        struct light_bounds bounds = light_bounds_of_triangle(triangle);
        double mean =
            ((double)light.intensity[0] + (double)light.intensity[1] + (double)light.intensity[2]) /
            3;
        list_add(list, &light, &bounds, GLM_PI * mean);
    }
}

static void list_lights(struct list *list, const struct emitters *emitters,
                        const struct scene *scene, const struct geometry *geometry) {
    struct emissive_triangles triangles;
    emissive_triangles_init(&triangles, scene, geometry, emitters);
    size_t most = (size_t)emitters->count + (size_t)triangles.count;
    *list = (struct list){mem_alloc(most, sizeof *list->lights),
                          mem_alloc(most, sizeof *list->bounds), 0};
    for (int i = 0; i < emitters->count; i++) {
        struct sampled_light light = light_of(&emitters->items[i]);
        struct light_bounds bounds = light_bounds_of(&emitters->items[i]);
        if (!emitters->items[i].stands_in)
            list_add(list, &light, &bounds, emitter_flux(&emitters->items[i], 1));
    }
    list_triangles(list, &triangles);
    emissive_triangles_free(&triangles);
}

/* Lights in the order of the tree's leaves, which lie near each other. */
struct ordered {
    struct light_node *nodes;
    const struct sampled_light *from;
    struct sampled_light *to;
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
    struct sampled_light *light = &ordered->to[ordered->count];
    *light = ordered->from[-1 - link];
    light->flux_before = (float)ordered->flux;
    ordered->nodes[node].link = -1 - ordered->count++;
    ordered->flux += (double)light->flux;
}

bool sampled_lights_init(struct sampled_lights *lights, const struct emitters *emitters,
                         const struct scene *scene, const struct geometry *geometry) {
    struct light_tree tree;
    struct list list;
    *lights = (struct sampled_lights){0};
    if (emitters->count == 0)
        return true;
    list_lights(&list, emitters, scene, geometry);
    light_tree_init(&tree, list.bounds, list.count);
    struct ordered ordered = {.nodes = tree.nodes,
                              .from = list.lights,
                              .to = mem_alloc((size_t)list.count + 1, sizeof *ordered.to)};
    if (tree.node_count > 0)
        order_below(&ordered, 0);
    for (int i = 0; i < ordered.count; i++) {
        ordered.to[i].flux_before /= (float)ordered.flux;
        ordered.to[i].flux /= (float)ordered.flux;
    }
    lights->flux = ordered.flux;
    /* Of dark lights alone one dark node and one light are left. */
    static const struct light_node dark[2];
    size_t nodes = tree.node_count > 0 ? (size_t)tree.node_count : 2;
    size_t count = ordered.count > 0 ? (size_t)ordered.count : 1;
    bool ok = buffer_init_texels(&lights->nodes, GL_RGBA32F, "light tree", nodes * sizeof *dark,
                                 tree.node_count > 0 ? tree.nodes : dark) &&
              buffer_init_texels(&lights->lights, GL_RGBA32F, "sampled lights",
                                 count * sizeof *ordered.to, ordered.to);
    mem_free(ordered.to, list.lights, list.bounds);
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
