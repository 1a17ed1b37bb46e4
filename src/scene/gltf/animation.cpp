/* Animations become clips. */
#include "scene/gltf/model.hpp"

extern "C" {
#include "scene/animation.h"
#include "scene/clips.h"
}

#include <cmath>

namespace gltf {
namespace {

/* No coordinate of geometry_init is farther out, and no product of two such leaves floats. */
const float max_value = 1e15F;

bool load_times(Loader &loader, int index, struct channel &to) {
    size_t count = loader.model.accessors[index].count;
    if (loader.model.accessors[index].componentType != COMPONENT_FLOAT)
        return error_set("accessor %d does not hold floats", index);
    if (!load_elements(loader, index, 1, count, &to.times))
        return false;
    to.key_count = int(count);
    for (int i = 0; i < to.key_count; i++)
        if (!std::isfinite(to.times[i]) || to.times[i] < 0 ||
            (i > 0 && to.times[i] <= to.times[i - 1]))
            return error_set("time %d is %g s, and times are finite, not negative and increase", i,
                             double(to.times[i]));
    return true;
}

/* A quaternion that is used as a value, and not as a tangent, has a direction. */
bool check_rotations(const struct channel &channel) {
    bool cubic = channel.interpolation == INTERPOLATION_CUBIC;
    for (int key = 0; key < channel.key_count; key++) {
        const float *q = channel.values + size_t(cubic ? key * 3 + 1 : key) * 4;
        if (std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3])) < 1e-6)
            return error_set("value %d is a quaternion of length 0", key);
    }
    return true;
}

bool load_values(Loader &loader, int index, struct channel &to) {
    size_t keys = size_t(to.key_count) * (to.interpolation == INTERPOLATION_CUBIC ? 3 : 1);
    bool weights = to.path == CHANNEL_WEIGHTS;
    size_t elements = weights ? keys * size_t(to.width) : keys;
    if (!load_elements(loader, index, weights ? 1 : to.width, elements, &to.values))
        return false;
    for (size_t i = 0; i < keys * size_t(to.width); i++)
        if (!(std::fabs(to.values[i]) <= max_value))
            return error_set("number %zu is %g", i, double(to.values[i]));
    return to.path != CHANNEL_ROTATION || check_rotations(to);
}

enum interpolation find_interpolation(const std::string &name) {
    return name == "STEP"          ? INTERPOLATION_STEP
           : name == "CUBICSPLINE" ? INTERPOLATION_CUBIC
                                   : INTERPOLATION_LINEAR;
}

bool load_keys(Loader &loader, const tinygltf::AnimationSampler &sampler, struct channel &to) {
    to.interpolation = find_interpolation(sampler.interpolation);
    if (!load_times(loader, sampler.input, to))
        return error_prefix("input");
    return load_values(loader, sampler.output, to) || error_prefix("output");
}

/* Nothing is left of a channel that failed. */
void drop_keys(struct channel &channel) {
    free(channel.times);
    free(channel.values);
    channel = {};
}

bool load_channel(Loader &loader, const tinygltf::Animation &animation,
                  const tinygltf::AnimationChannel &from, const std::string &object,
                  struct clip &clip) {
    struct channel &to = clip.channels[clip.channel_count];
    const std::string pointer = pointer_of(from);
    bool is_known = true;
    if (pointer.empty())
        return true;
    bool good = find_property(loader, pointer, to, is_known);
    if (!is_known)
        lack(loader,
             "animation of '" + clean(from.target_node < 0 ? pointer : from.target_path) + "'");
    if (good && (!is_known || to.target < 0))
        return true;
    if (!good || !load_keys(loader, animation.samplers[from.sampler], to)) {
        drop_keys(to);
        return mend(loader, bad_clips, object + ": " + error_get());
    }
    clip.channel_count++;
    clip.duration = std::fmax(clip.duration, to.times[to.key_count - 1]);
    return true;
}

bool load_clip(Loader &loader, const tinygltf::Animation &from, size_t index, struct clip &to) {
    const std::string object = label("animation", index, from.name) + ": channel ";
    copy_name(to.name, from.name);
    to.channels = allocate<struct channel>(from.channels.size());
    for (size_t i = 0; i < from.channels.size(); i++)
        if (!load_channel(loader, from, from.channels[i], object + std::to_string(i), to))
            return false;
    return true;
}

} // namespace

bool load_clips(Loader &loader) {
    const auto &from = loader.model.animations;
    struct scene *scene = loader.scene;
    scene->clips = allocate<struct clip>(from.size());
    scene->clip_count = int(from.size());
    for (size_t i = 0; i < from.size(); i++)
        if (!load_clip(loader, from[i], i, scene->clips[i]))
            return false;
    clips_play_default(scene);
    return true;
}

} // namespace gltf
