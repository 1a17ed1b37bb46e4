#include "scene/recentre.h"

#include <cglm/cglm.h>

/* Nearer than so many radii floats are fine to a ten thousandth of the radius: enough. */
static const float far_radii = 1000;

static void shift(const struct scene *scene, float position[3]) {
    for (int c = 0; c < 3; c++)
        position[c] = (float)((double)position[c] - scene->origin[c]);
}

/* A cubic's tangents are differences and stay. */
static void shift_channel(const struct scene *scene, struct channel *channel) {
    bool cubic = channel->interpolation == INTERPOLATION_CUBIC;
    for (int key = 0; key < channel->key_count; key++)
        shift(scene, channel->values + (size_t)(cubic ? 3 * key + 1 : key) * 3);
}

static void shift_roots(struct scene *scene) {
    for (int i = 0; i < scene->node_count; i++) {
        struct node *node = &scene->nodes[i];
        if (node->parent < 0)
            shift(scene, node->has_matrix ? &node->matrix[12] : node->translation);
    }
    for (int c = 0; c < scene->clip_count; c++)
        for (int i = 0; i < scene->clips[c].channel_count; i++) {
            struct channel *channel = &scene->clips[c].channels[i];
            if (channel->path == CHANNEL_TRANSLATION && scene->nodes[channel->target].parent < 0)
                shift_channel(scene, channel);
        }
}

/* Whole multiples of a power of two near the radius: subtracting them rounds nothing. */
static void set_origin(struct scene *scene, const struct geometry *geometry) {
    double step = exp2(ceil(log2((double)geometry->radius)));
    for (int c = 0; c < 3; c++)
        scene->origin[c] = round((double)geometry->center[c] / step) * step;
}

bool scene_recentre(struct scene *scene, const struct geometry *geometry) {
    if (glm_vec3_norm((float *)geometry->center) <= far_radii * geometry->radius)
        return false;
    set_origin(scene, geometry);
    shift_roots(scene);
    return true;
}
