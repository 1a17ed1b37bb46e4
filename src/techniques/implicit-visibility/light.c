#include "techniques/implicit-visibility/light.h"

#include "base/memory.h"
#include "base/parallel.h"
#include "scene/mesh/bvh_ray.h"
#include "scene/mesh/opacity.h"
#include "scene/mesh/pane_triangles.h"

#include <math.h>
#include <string.h>

enum { LEAVES_TOGETHER = 64 };

void element_light_init(struct element_light *light, const struct tree *tree) {
    const size_t leaves = (size_t)tree->leaf_count, nodes = (size_t)tree->count;
    *light = (struct element_light){
        .count = tree->leaf_count,
        .node_count = tree->count,
        .direct = mem_alloc(leaves, sizeof *light->direct),
        .radiance = mem_alloc(nodes, sizeof *light->radiance),
        .irradiance = mem_alloc(leaves, sizeof *light->irradiance),
    };
}

void element_light_free(struct element_light *light) {
    mem_free(light->direct, light->radiance, light->irradiance, light->emission);
    *light = (struct element_light){0};
}

void element_light_emit(struct element_light *light, const struct elements *elements,
                        const struct tree *tree) {
    float most = 0;
    for (int i = 0; i < elements->count; i++)
        most = fmaxf(most, glms_vec3_max(elements->items[i].emission));
    if (!(most > 0))
        return;
    if (!light->emission)
        light->emission = mem_alloc((size_t)light->node_count, sizeof *light->emission);
    for (int i = 0; i < elements->count; i++)
        memcpy(light->emission[i], elements->items[i].emission.raw, 3 * sizeof(float));
    tree_pull_up_values(tree, light->emission);
}

void element_light_dim(struct element_light *light, const struct elements *elements,
                       const struct tree *tree, const struct lamps *lamps) {
    if (!light->emission)
        return;
    for (int i = 0; i < elements->count; i++)
        for (int c = 0; c < 3; c++)
            light->emission[i][c] =
                elements->items[i].emission.raw[c] * lamps->share[lamps->of_elements[i]][c];
    tree_pull_up_values(tree, light->emission);
}

static void plant(struct bvh *tree, struct triangle_parts list) {
    if (list.count > 0)
        bvh_init(tree, list.items, list.count);
}

void element_light_casters(struct bvh *casters, struct bvh *panes, const struct scene *scene,
                           const struct geometry *geometry) {
    plant(casters, opaque_triangles_of(scene, geometry));
    plant(panes, pane_triangles_of(scene, geometry));
}

/* --- environment ------------------------------------------------------------------------------ */

/* All texels by their middles; a bin without one takes what lies in its own middle. */
float (*element_light_sky(const struct bins *bins, const struct environment *environment))[3] {
    float(*sky)[3] = mem_alloc((size_t)bins->count, sizeof *sky);
    double(*sums)[4] = mem_alloc((size_t)bins->count, sizeof *sums);
    for (int y = 0; y < environment->height; y++) {
        double solid_angle = environment_solid_angle(environment, y);
        for (int x = 0; x < environment->width; x++) {
            float direction[3], radiance[3];
            environment_direction(environment, x + .5, y + .5, direction);
            environment_radiance(environment, direction, radiance);
            double *sum = sums[bins_find(bins, direction)];
            for (int c = 0; c < 3; c++)
                sum[c] += solid_angle * (double)radiance[c];
            sum[3] += solid_angle;
        }
    }
    for (int b = 0; b < bins->count; b++) {
        environment_radiance(environment, bins->directions[b].raw, sky[b]);
        for (int c = 0; sums[b][3] > 0 && c < 3; c++)
            sky[b][c] = (float)(sums[b][c] / sums[b][3]);
    }
    free(sums);
    return sky;
}

/* --- direct light ----------------------------------------------------------------------------- */

struct lighting {
    struct element_light *light;
    const struct elements *elements;
    const struct direct_lights *lights;
    const struct links *links;
};

static bool is_hidden(const struct direct_lights *lights, const struct element *element,
                      vec3s to_light, float distance) {
    vec3s origin = glms_vec3_muladds(element->normal, lights->clearance, element->position);
    if (lights->casters->count == 0)
        return false;
    struct bvh_hit hit = bvh_ray_trace_opaque(lights->casters, origin, to_light);
    return hit.distance < distance - lights->clearance;
}

/* Irradiance over intensity. */
static vec3s arriving(const struct direct_lights *lights, const struct emitter *light,
                      const struct element *element) {
    const vec3s axis = {{light->direction[0], light->direction[1], light->direction[2]}};
    vec3s to_light = glms_vec3_negate(axis);
    float distance = INFINITY, factor = 1;
    if (light->type != EMITTER_DIRECTIONAL) {
        const vec3s at = {{light->position[0], light->position[1], light->position[2]}};
        vec3s path = glms_vec3_sub(at, element->position);
        distance = glms_vec3_norm(path);
        if (!(distance > 0))
            return glms_vec3_zero();
        to_light = glms_vec3_scale(path, 1 / distance);
        factor = emitter_cone(light, -glms_vec3_dot(to_light, axis)) *
                 emitter_in_range(light, distance) / (distance * distance);
    }
    factor *= glms_vec3_dot(to_light, element->normal);
    if (!(factor > 0) || is_hidden(lights, element, to_light, distance))
        return glms_vec3_zero();
    return glms_vec3_scale(
        pane_triangles_pass(lights->panes, element->position, to_light, distance), factor);
}

/* Intensity towards the element, but for the cone. */
static vec3s intensity_to(const struct emitter *light, const struct element *element) {
    vec3s intensity = {{light->intensity[0], light->intensity[1], light->intensity[2]}}, slide;
    const vec3s at = {{light->position[0], light->position[1], light->position[2]}};
    if (!light->slide)
        return intensity;
    emitter_slide(light, vec3s_unit(glms_vec3_sub(element->position, at)).raw, slide.raw);
    return glms_vec3_mul(intensity, slide);
}

static void light_some(void *context, size_t run) {
    const struct lighting *lighting = context;
    int first = (int)run * LEAVES_TOGETHER, end = first + LEAVES_TOGETHER;
    for (int i = first; i < end && i < lighting->light->count; i++) {
        const float *sky = lighting->links->sky[i];
        vec3s sum = {{sky[0], sky[1], sky[2]}};
        if (lighting->lights->lamps_by_links && lighting->light->emission)
            sum = glms_vec3_add(sum,
                                links_gather_lamps(lighting->links, i,
                                                   (const float(*)[4])lighting->light->emission));
        for (int l = 0; l < lighting->lights->count; l++) {
            const struct emitter *light = &lighting->lights->items[l];
            if (lighting->lights->lamps_by_links && light->lamp > 0)
                continue;
            const struct element *element = &lighting->elements->items[i];
            vec3s factor = arriving(lighting->lights, light, element);
            sum = glms_vec3_muladd(intensity_to(light, element), factor, sum);
        }
        glm_vec3_copy(sum.raw, lighting->light->direct[i]);
    }
}

static void for_leaves(const struct lighting *lighting, void (*body)(void *context, size_t run)) {
    size_t runs = ((size_t)lighting->light->count + LEAVES_TOGETHER - 1) / LEAVES_TOGETHER;
    parallel_for(runs, lighting->links->desc.threads, body, (void *)lighting);
}

void element_light_direct(struct element_light *light, const struct elements *elements,
                          const struct direct_lights *lights, const struct links *links) {
    for_leaves(&(struct lighting){light, elements, lights, links}, light_some);
}

/* --- bounces ---------------------------------------------------------------------------------- */

static void gather_some(void *context, size_t run) {
    const struct lighting *lighting = context;
    struct element_light *light = lighting->light;
    int first = (int)run * LEAVES_TOGETHER, end = first + LEAVES_TOGETHER;
    for (int i = first; i < end && i < light->count; i++) {
        vec3s sum = links_gather(lighting->links, i, (const float(*)[4])light->radiance);
        glm_vec3_copy(sum.raw, light->irradiance[i]);
    }
}

static void reflect(const struct element_light *light, const struct elements *elements,
                    bool indirect_too) {
    for (int i = 0; i < light->count; i++)
        for (int c = 0; c < 3; c++) {
            float arrives = light->direct[i][c] + (indirect_too ? light->irradiance[i][c] : 0);
            light->radiance[i][c] = elements->items[i].albedo.raw[c] * arrives / GLM_PIf;
        }
}

void element_light_bounce(struct element_light *light, const struct elements *elements,
                          const struct tree *tree, const struct links *links, int bounces) {
    for (int bounce = 0; bounce < bounces; bounce++) {
        reflect(light, elements, bounce > 0);
        tree_pull_up_values(tree, light->radiance);
        for_leaves(&(struct lighting){light, elements, NULL, links}, gather_some);
    }
}
