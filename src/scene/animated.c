#include "scene/animated.h"

#include "base/memory.h"
#include "scene/animation.h"
#include "scene/material.h"

#include <cglm/vec4.h>

#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

/* --- one object ------------------------------------------------------------------------------- */

/* Writes an object's numbers as channels have them into its copy. False: no channel is the
 * object's. */
static bool animate(const struct scene *scene, enum channel_path path, int target, double time,
                    void *copy) {
    const struct channel *channel;
    bool any = false;
    for (struct channel_place place = {0}; (channel = scene_next_channel(scene, &place));) {
        if (channel->path != path || channel->target != target)
            continue;
        float *numbers = (void *)((char *)copy + channel->offset);
        channel_sample(channel, time, numbers);
        for (int i = 0; i < channel->width; i++)
            numbers[i] = fminf(fmaxf(numbers[i], channel->least), channel->most);
        any = true;
    }
    return any;
}

static struct material animated_material(const struct scene *scene, int material, double time) {
    struct material copy = scene->still_materials[material];
    if (animate(scene, CHANNEL_MATERIAL, material, time, &copy))
        for (int c = 0; c < 3; c++)
            copy.emission[c] =
                fminf(copy.emissive_factor[c] * copy.emissive_strength, SCENE_LIGHT_MOST);
    return copy;
}

struct scene_light animated_light(const struct scene *scene, int light, double time) {
    struct scene_light copy = scene->lights[light];
    if (animate(scene, CHANNEL_LIGHT, light, time, &copy)) {
        for (int c = 0; c < 3; c++)
            copy.intensity[c] = fminf(copy.color[c] * copy.strength * copy.scale, SCENE_LIGHT_MOST);
        copy.inner = fminf(copy.inner, copy.outer);
    }
    if (copy.material > 0) {
        const struct material material = animated_material(scene, copy.material - 1, time);
        for (int c = 0; c < 3; c++)
            copy.intensity[c] *= material.emission[c];
    }
    return copy;
}

struct scene_camera animated_camera(const struct scene *scene, int camera, double time) {
    struct scene_camera copy = scene->cameras[camera];
    if (animate(scene, CHANNEL_CAMERA, camera, time, &copy) && copy.far <= copy.near)
        copy.far = 0;
    return copy;
}

/* --- materials -------------------------------------------------------------------------------- */

static void brighten(struct material *material, const struct channel *channel) {
    float *most = (void *)((char *)material + channel->offset);
    int numbers = channel->key_count * (channel->interpolation == INTERPOLATION_CUBIC ? 3 : 1);
    for (int i = 0; i < numbers * channel->width; i++)
        most[i % channel->width] = fmaxf(most[i % channel->width], channel->values[i]);
}

static bool is_of_emission(const struct channel *channel) {
    return channel->offset >= offsetof(struct material, emissive_factor);
}

static bool is_of_reflection(const struct channel *channel) {
    return channel->offset == offsetof(struct material, metalness) ||
           channel->offset == offsetof(struct material, roughness);
}

/* Runs over the channels of all clips, whether they play or not. */
static void keep_material(struct scene *scene, const struct channel *channel) {
    if (!scene->still_materials)
        scene->still_materials =
            mem_copy(scene->materials, (size_t)scene->material_count, sizeof *scene->materials);
    struct material *material = &scene->materials[channel->target];
    material->is_animated = true;
    material->may_shine |= is_of_reflection(channel);
    scene->still_materials[channel->target].is_animated = true;
    scene->still_materials[channel->target].may_shine = material->may_shine;
    if (!is_of_emission(channel))
        return;
    brighten(material, channel);
    for (int c = 0; c < 3; c++)
        material->emission[c] =
            fminf(material->emissive_factor[c] * material->emissive_strength, SCENE_LIGHT_MOST);
}

void animated_keep_materials(struct scene *scene) {
    for (int n = 0; n < scene->clip_count; n++)
        for (int i = 0; i < scene->clips[n].channel_count; i++)
            if (scene->clips[n].channels[i].path == CHANNEL_MATERIAL)
                keep_material(scene, &scene->clips[n].channels[i]);
}

/* The one material of a lamp's surfaces; -1: they have several. */
static int material_of(const struct scene *scene, int lamp) {
    int found = -1;
    for (int i = 0; i < scene->surface_count; i++) {
        const struct emissive_surface *surface = &scene->surfaces[i];
        int mesh = scene->nodes[surface->node].mesh;
        int material = scene->meshes[mesh].primitives[surface->primitive].material;
        if (surface->lamp != lamp || material == found)
            continue;
        if (found >= 0)
            return -1;
        found = material;
    }
    return found;
}

void animated_follow_materials(struct scene *scene) {
    for (int i = 0; scene->still_materials && i < scene->light_count; i++) {
        struct scene_light *light = &scene->lights[i];
        int material = light->lamp ? material_of(scene, light->lamp) : -1;
        if (material < 0 || !scene->materials[material].is_animated)
            continue;
        light->material = material + 1;
        for (int c = 0; c < 3; c++) {
            float brightest = scene->materials[material].emission[c];
            light->intensity[c] = brightest > 0 ? light->intensity[c] / brightest : 0;
        }
    }
}

/* Of panes the colour, too. */
static bool is_opacity_same(const struct material *a, const struct material *b) {
    return (!a->alpha_mask ||
            (a->base_color[3] == b->base_color[3] && a->alpha_cutoff == b->alpha_cutoff)) &&
           (!material_is_pane(a) || (glm_vec4_eqv((float *)a->base_color, (float *)b->base_color) &&
                                     a->transmission == b->transmission));
}

enum animated_change animated_pose_materials(struct scene *scene, double time) {
    enum animated_change change = ANIMATED_NOTHING;
    for (int i = 0; scene->still_materials && i < scene->material_count; i++) {
        if (!scene->still_materials[i].is_animated)
            continue;
        const struct material new = animated_material(scene, i, time);
        struct material *old = &scene->materials[i];
        if (memcmp(&new, old, sizeof new) == 0)
            continue;
        if (change != ANIMATED_OPACITY)
            change = is_opacity_same(&new, old) ? ANIMATED_COLORS : ANIMATED_OPACITY;
        *old = new;
    }
    return change;
}
