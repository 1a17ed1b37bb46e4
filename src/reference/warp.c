#include "reference/warp.h"

#include <math.h>

/* An orthonormal frame about an axis [Duff et al. 2017]. */
struct frame {
    vec3s right, up;
};

static struct frame frame_about(vec3s axis) {
    float sign = copysignf(1, axis.z);
    float a = -1 / (sign + axis.z), b = axis.x * axis.y * a;
    return (struct frame){{{1 + sign * axis.x * axis.x * a, sign * b, -sign * axis.x}},
                          {{b, sign + axis.y * axis.y * a, -axis.y}}};
}

vec3s warp_perpendicular(vec3s axis) {
    return frame_about(axis).right;
}

static vec3s about_axis(vec3s axis, float x, float y, float z) {
    struct frame frame = frame_about(axis);
    return glms_vec3_add(glms_vec3_scale(axis, z), glms_vec3_add(glms_vec3_scale(frame.right, x),
                                                                 glms_vec3_scale(frame.up, y)));
}

static vec3s at_radius(vec3s axis, float radius, float turn, float height) {
    float angle = 2 * GLM_PIf * turn;
    return about_axis(axis, radius * cosf(angle), radius * sinf(angle), height);
}

vec3s warp_to_cosine(vec2s sample, vec3s normal) {
    return at_radius(normal, sqrtf(sample.x), sample.y, sqrtf(1 - sample.x));
}

vec3s warp_to_cone(vec2s sample, vec3s axis, float cos_half_angle) {
    return warp_to_cap(sample, axis, 1 - cos_half_angle);
}

vec3s warp_to_cap(vec2s sample, vec3s axis, float height) {
    /* All heights of the cap are equally likely. */
    float sine = sqrtf(fmaxf(0, sample.x * height * (2 - sample.x * height)));
    return at_radius(axis, sine, sample.y, 1 - sample.x * height);
}

vec3s warp_to_disc(vec2s sample, vec3s axis) {
    return at_radius(axis, sqrtf(sample.x), sample.y, 0);
}
