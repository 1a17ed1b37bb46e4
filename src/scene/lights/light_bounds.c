#include "scene/lights/light_bounds.h"

#include "base/extremes.h"
#include "base/unit.h"
#include "shared/light_tree.h"

#include <math.h>

static float mean_intensity(const struct emitter *emitter) {
    const float *rgb = emitter->intensity;
    return (rgb[0] + rgb[1] + rgb[2]) / 3;
}

/* Half the sides of the box around the shape; of a cap, around its directions. */
static void half_sides(const struct emitter *emitter, float half[3]) {
    for (int c = 0; c < 3; c++) {
        float x = emitter->right[c] * emitter->size[0] / 2, y = emitter->up[c], z = 0;
        y *= emitter->size[emitter_shape(emitter) == EMITTER_IS_RECTANGLE] / 2;
        if (emitter_shape(emitter) == EMITTER_IS_SPHERE)
            z = emitter->direction[c] * emitter->size[0] / 2;
        half[c] = emitter_shape(emitter) == EMITTER_IS_RECTANGLE ? fabsf(x) + fabsf(y)
                  : emitter_shape(emitter) == EMITTER_IS_POINT   ? 0
                                                                 : sqrtf(x * x + y * y + z * z);
        if (emitter_shape(emitter) == EMITTER_IS_CAP)
            half[c] = 2 * sinf(emitter->size[0] / 4);
    }
}

struct light_bounds light_bounds_of(const struct emitter *emitter) {
    bool is_distant = emitter->type == EMITTER_DIRECTIONAL, is_spot = emitter->type == EMITTER_SPOT;
    bool is_area = emitter->type == EMITTER_AREA;
    float inner = acosf(fminf(emitter->cos_outer + emitter_falloff_width(emitter), 1));
    struct light_bounds bounds = {
        .theta_o = is_spot   ? inner
                   : is_area ? 0
                             : GLM_PIf,
        .theta_e = is_spot ? acosf(emitter->cos_outer) - inner : GLM_PI_2f,
        .power = mean_intensity(emitter),
        .reach = is_distant           ? 0
                 : emitter->range > 0 ? emitter->range
                                      : INFINITY,
    };
    float half[3];
    half_sides(emitter, half);
    for (int c = 0; c < 3; c++) {
        float center = is_distant ? -emitter->direction[c] : emitter->position[c];
        bounds.axis[c] = emitter->direction[c];
        bounds.low[c] = center - half[c];
        bounds.high[c] = center + half[c];
    }
    return bounds;
}

struct light_bounds light_bounds_of_triangle(const struct light_triangle *triangle) {
    struct light_bounds bounds = {.theta_e = GLM_PI_2f, .reach = INFINITY};
    vec3 across;
    glm_vec3_cross((float *)triangle->edge_1, (float *)triangle->edge_2, across);
    float mean = (triangle->red + triangle->green + triangle->blue) / 3;
    bounds.power = mean * glm_vec3_norm(across) / 2;
    vec3_unit_to(across, bounds.axis);
    for (int c = 0; c < 3; c++) {
        float one = triangle->edge_1[c], two = triangle->edge_2[c];
        bounds.low[c] = triangle->corner[c] + float_min(float_min(one, two), 0);
        bounds.high[c] = triangle->corner[c] + float_max(float_max(one, two), 0);
    }
    return bounds;
}

/* Makes the narrowest cone around two: theirs, or one whose axis lies between their axes. */
static void merge_cones(struct light_bounds *wide, const struct light_bounds *narrow) {
    float cosine = glm_clamp(glm_vec3_dot(wide->axis, (float *)narrow->axis), -1, 1);
    float between = wide->theta_o < GLM_PIf ? acosf(cosine) : 0;
    if (fminf(between + narrow->theta_o, GLM_PIf) <= wide->theta_o)
        return;
    float theta_o = (wide->theta_o + between + narrow->theta_o) / 2;
    float turn = theta_o - wide->theta_o;
    vec3 across;
    glm_vec3_copy((float *)narrow->axis, across);
    glm_vec3_muladds(wide->axis, -cosine, across);
    vec3_unit(across);
    if (theta_o >= GLM_PIf || cosine <= -1) {
        wide->theta_o = GLM_PIf;
        return;
    }
    glm_vec3_scale(wide->axis, cosf(turn), wide->axis);
    glm_vec3_muladds(across, sinf(turn), wide->axis);
    vec3_unit(wide->axis);
    wide->theta_o = theta_o;
}

struct light_bounds light_bounds_merge(const struct light_bounds *a, const struct light_bounds *b) {
    bool first = !(b->power > 0) || (a->power > 0 && a->theta_o >= b->theta_o);
    const struct light_bounds *other = first ? b : a;
    struct light_bounds sum = first ? *a : *b;
    if (!(other->power > 0))
        return sum;
    merge_cones(&sum, other);
    for (int c = 0; c < 3; c++) {
        sum.low[c] = float_min(a->low[c], b->low[c]);
        sum.high[c] = float_max(a->high[c], b->high[c]);
    }
    sum.theta_e = float_max(a->theta_e, b->theta_e);
    sum.power = a->power + b->power;
    sum.reach = float_max(a->reach, b->reach);
    return sum;
}

float light_bounds_orientation(const struct light_bounds *bounds) {
    float o = bounds->theta_o, w = fminf(o + bounds->theta_e, GLM_PIf);
    if (o >= GLM_PIf)
        return 4 * GLM_PIf;
    return 2 * GLM_PIf * (1 - cosf(o)) +
           GLM_PI_2f * (2 * w * sinf(o) - cosf(o - 2 * w) - 2 * o * sinf(o) + cosf(o));
}
