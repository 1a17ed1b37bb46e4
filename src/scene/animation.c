#include "scene/animation.h"

#include "scene/shapes/metaballs.h"

#include <cglm/cglm.h>
#include <stdlib.h>
#include <string.h>

/* Returns the last key at or before the time. Compares floats: the float of 1/10 s is a little
 * above the double, so frame 1/10 s would miss its key. */
static int key_before(const struct channel *channel, double time) {
    int low = 0, high = channel->key_count;
    while (high - low > 1) {
        int middle = (low + high) / 2;
        *(channel->times[middle] <= (float)time ? &low : &high) = middle;
    }
    return low;
}

enum cubic_part { IN_TANGENT, VALUE, OUT_TANGENT };

static const float *key_value(const struct channel *channel, int key, enum cubic_part part) {
    size_t width = (size_t)channel->width;
    return channel->interpolation == INTERPOLATION_CUBIC
               ? channel->values + ((size_t)key * 3 + part) * width
               : channel->values + (size_t)key * width;
}

static void slerp(const float *from, const float *to, float t, float *out) {
    versor a, b;
    memcpy(a, from, sizeof a);
    memcpy(b, to, sizeof b);
    glm_quat_normalize(a);
    glm_quat_normalize(b);
    glm_quat_slerp(a, b, t, out);
}

/* Hermite's cubic through two keys `step` seconds apart [glTF 2.0, appendix C.5]. */
static void hermite(const struct channel *channel, int key, double t, double step, float *out) {
    const float *from = key_value(channel, key, VALUE), *to = key_value(channel, key + 1, VALUE);
    const float *leaving = key_value(channel, key, OUT_TANGENT);
    const float *coming = key_value(channel, key + 1, IN_TANGENT);
    double t2 = t * t, t3 = t2 * t;
    for (int i = 0; i < channel->width; i++)
        out[i] = (float)((2 * t3 - 3 * t2 + 1) * (double)from[i] +
                         step * (t3 - 2 * t2 + t) * (double)leaving[i] +
                         (3 * t2 - 2 * t3) * (double)to[i] + step * (t3 - t2) * (double)coming[i]);
}

/* Between two keys, t in [0, 1] of the way. */
static void interpolate(const struct channel *channel, int key, double t, double step, float *out) {
    const float *from = key_value(channel, key, VALUE);
    switch (channel->interpolation) {
    case INTERPOLATION_STEP:
        memcpy(out, from, (size_t)channel->width * sizeof *out);
        return;
    case INTERPOLATION_CUBIC:
        hermite(channel, key, t, step, out);
        return;
    case INTERPOLATION_LINEAR:
        break;
    }
    const float *to = key_value(channel, key + 1, VALUE);
    if (channel->path == CHANNEL_ROTATION)
        slerp(from, to, (float)t, out);
    else
        for (int i = 0; i < channel->width; i++)
            out[i] = (float)((1 - t) * (double)from[i] + t * (double)to[i]);
}

void channel_sample(const struct channel *channel, double time, float *out) {
    int key = key_before(channel, time), last = channel->key_count - 1;
    double start = (double)channel->times[key];
    if (key == last || time <= start) {
        memcpy(out, key_value(channel, key, VALUE), (size_t)channel->width * sizeof *out);
    } else {
        double step = (double)channel->times[key + 1] - start;
        interpolate(channel, key, (time - start) / step, step, out);
    }
    if (channel->path == CHANNEL_ROTATION)
        glm_quat_normalize(out);
}

const struct channel *scene_next_channel(const struct scene *scene, struct channel_place *place) {
    while (place->playing < scene->playing_count) {
        const struct clip *clip = &scene->clips[scene->playing[place->playing]];
        if (place->channel < clip->channel_count)
            return &clip->channels[place->channel++];
        *place = (struct channel_place){place->playing + 1, 0};
    }
    return NULL;
}

double scene_duration(const struct scene *scene) {
    double duration = 0;
    for (int i = 0; i < scene->playing_count; i++)
        duration = fmax(duration, (double)scene->clips[scene->playing[i]].duration);
    for (int i = 0; i < scene->node_count; i++)
        if (scene->nodes[i].metaballs >= 0)
            duration = fmax(duration, (double)scene->metaballs[scene->nodes[i].metaballs].period);
    return duration;
}

void clip_free(struct clip *clip) {
    for (int i = 0; i < clip->channel_count; i++) {
        mem_free(clip->channels[i].times, clip->channels[i].values);
    }
    free(clip->channels);
    *clip = (struct clip){0};
}
