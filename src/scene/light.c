#include "scene/light.h"

#include "scene/node.h"

#include <cglm/cglm.h>
#include <string.h>

int light_node_count(const struct scene *scene) {
    return node_count_carrying(scene, NODE_LIGHT);
}

int light_find(const struct scene *scene, const char *text) {
    return node_find_carrying(scene, NODE_LIGHT, text);
}

void light_place(struct light *light, const struct scene *scene, int n, double time) {
    int node = node_carrying(scene, NODE_LIGHT, n);
    const struct scene_light *source = &scene->lights[scene->nodes[node].light];
    float world[16];
    node_world(scene, node, time, world);
    *light = (struct light){
        .type = source->type, .cos_inner = cosf(source->inner), .cos_outer = cosf(source->outer)};
    memcpy(light->intensity, source->intensity, sizeof light->intensity);
    memcpy(light->position, &world[12], sizeof light->position);
    node_frame(world, light->right, light->up, light->direction);
}

void light_aim(struct light *light, const float direction[3]) {
    vec3 forward, right;
    glm_vec3_normalize_to((float *)direction, forward);
    /* Straight up and down, the frame turns about z. */
    vec3 aside = {0, fabsf(forward[1]) < .99F, fabsf(forward[1]) >= .99F};
    glm_vec3_cross(forward, aside, right);
    glm_vec3_normalize(right);
    glm_vec3_copy(forward, light->direction);
    glm_vec3_copy(right, light->right);
    glm_vec3_cross(right, forward, light->up);
}

float light_cone(const struct light *light, float cos_angle) {
    if (light->type != LIGHT_SPOT)
        return 1;
    float width = fmaxf(.001F, light->cos_inner - light->cos_outer);
    float falloff = glm_clamp((cos_angle - light->cos_outer) / width, 0, 1);
    return falloff * falloff;
}

double light_solid_angle(const struct light *light) {
    switch (light->type) {
    case LIGHT_SPOT:
        return 2 * GLM_PI * (1 - (double)light->cos_outer);
    case LIGHT_POINT:
        return 4 * GLM_PI;
    case LIGHT_DIRECTIONAL:
        break;
    }
    return 0;
}
