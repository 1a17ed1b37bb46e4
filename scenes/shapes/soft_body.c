#include "shapes/soft_body.h"

#include <assert.h>
#include <cglm/cglm.h>
#include <float.h>
#include <math.h>

/* Distances beyond this are of no interest: no seam is that wide. */
static const float far_away = 0.17f;

/* --- distances -------------------------------------------------------------------------------- */

/* The radius runs linearly along the axis; not the exact distance, but zero where it should be. */
static float bone_distance(const struct bone *bone, vec3 p) {
    float flat = bone->flat > 0.0f ? bone->flat : 1.0f;
    vec3 axis, from;
    glm_vec3_sub((float *)bone->to, (float *)bone->from, axis);
    glm_vec3_sub(p, (float *)bone->from, from);
    float t = glm_clamp_zo(glm_vec3_dot(from, axis) / glm_vec3_norm2(axis));
    glm_vec3_muladds(axis, -t, from);
    from[2] /= flat;
    return glm_vec3_norm(from) - glm_lerp(bone->from_radius, bone->to_radius, t);
}

/* First order: the implicit function over the length of its gradient. p lies in the ellipsoid's own
 * axes. */
static float muscle_distance(const struct muscle *muscle, vec3 p) {
    vec3 scaled, gradient;
    glm_vec3_div(p, (float *)muscle->radii, scaled);
    glm_vec3_div(scaled, (float *)muscle->radii, gradient);
    float length = glm_vec3_norm(scaled), slope = glm_vec3_norm(gradient);
    /* At the centre the formula is 0 / 0; any clearly negative distance will do. */
    return slope > 1e-6f ? length * (length - 1.0f) / slope : -glm_vec3_min((float *)muscle->radii);
}

static float smooth_min(float a, float b, float width) {
    float overlap = fmaxf(width - fabsf(a - b), 0.0f);
    return fminf(a, b) - overlap * overlap / (4.0f * fmaxf(width, 1e-6f));
}

static float join(const struct soft_part *part, float before, const float point[3]) {
    const struct soft_frame *frame = &part->frame;
    vec3 d;
    glm_vec3_sub((float *)point, (float *)frame->origin, d);
    vec3 local = {glm_vec3_dot(d, (float *)frame->right), glm_vec3_dot(d, (float *)frame->up),
                  glm_vec3_dot(d, (float *)frame->front)};
    if (part->is_bone)
        return smooth_min(before, bone_distance(&part->bone, local), part->bone.blend);
    float distance = muscle_distance(&part->muscle, local);
    return part->carve ? -smooth_min(-before, distance, part->muscle.blend)
                       : smooth_min(before, distance, part->muscle.blend);
}

/* --- the field -------------------------------------------------------------------------------- */

static bool in_range(const struct soft_part *part, int axis, float value) {
    return value >= part->low[axis] && value <= part->high[axis];
}

static void field_row(const void *context, const float first[3], float step, int count,
                      float *values) {
    const struct soft_body *body = context;
    for (int i = 0; i < count; i++)
        values[i] = far_away;
    for (const struct soft_part *part = body->parts; part < body->parts + body->count; part++) {
        if (!in_range(part, 1, first[1]) || !in_range(part, 2, first[2]))
            continue;
        for (int i = 0; i < count; i++) {
            float point[3] = {first[0] + (float)i * step, first[1], first[2]};
            if (in_range(part, 0, point[0]))
                values[i] = join(part, values[i], point);
        }
    }
    for (int i = 0; i < count; i++)
        values[i] = -values[i];
}

static float field_value(const struct soft_body *body, const float point[3]) {
    float value;
    field_row(body, point, 0.0f, 1, &value);
    return value;
}

static void field_gradient(const void *context, const float point[3], float gradient[3]) {
    const float h = 1e-3f;
    for (int k = 0; k < 3; k++) {
        vec3 low, high;
        glm_vec3_copy((float *)point, low);
        glm_vec3_copy((float *)point, high);
        low[k] -= h;
        high[k] += h;
        gradient[k] = field_value(context, high) - field_value(context, low);
    }
}

struct implicit soft_implicit(const struct soft_body *body) {
    return (struct implicit){body, field_row, field_gradient};
}

struct marching_grid soft_grid(const struct soft_body *body, float step) {
    struct marching_grid grid = {.step = step};
    for (int axis = 0; axis < 3; axis++) {
        float low = FLT_MAX, high = -FLT_MAX;
        for (int i = 0; i < body->count; i++) {
            if (body->parts[i].carve)
                continue;
            low = fminf(low, body->parts[i].low[axis]);
            high = fmaxf(high, body->parts[i].high[axis]);
        }
        grid.low[axis] = low;
        grid.cells[axis] = (int)ceilf((high - low) / step);
    }
    return grid;
}

/* --- parts ------------------------------------------------------------------------------------ */

static void to_world(const struct soft_frame *frame, const float local[3], vec3 world) {
    glm_vec3_copy((float *)frame->origin, world);
    glm_vec3_muladds((float *)frame->right, local[0], world);
    glm_vec3_muladds((float *)frame->up, local[1], world);
    glm_vec3_muladds((float *)frame->front, local[2], world);
}

/* The box around a ball in the frame, far_away wider, joined to the part's box. */
static void cover(struct soft_part *part, const float center[3], float radius) {
    vec3 world;
    to_world(&part->frame, center, world);
    for (int axis = 0; axis < 3; axis++) {
        part->low[axis] = fminf(part->low[axis], world[axis] - radius - far_away);
        part->high[axis] = fmaxf(part->high[axis], world[axis] + radius + far_away);
    }
}

static struct soft_part *next_part(struct soft_body *body, const struct soft_frame *frame) {
    assert(body->count < SOFT_PARTS_MAX);
    struct soft_part *part = &body->parts[body->count++];
    *part = (struct soft_part){.frame = *frame,
                               .low = {FLT_MAX, FLT_MAX, FLT_MAX},
                               .high = {-FLT_MAX, -FLT_MAX, -FLT_MAX}};
    return part;
}

void soft_add_bone(struct soft_body *body, const struct soft_frame *frame, const struct bone *bone,
                   enum soft_side side) {
    struct soft_part *part = next_part(body, frame);
    part->is_bone = true;
    part->bone = *bone;
    cover(part, bone->from, bone->from_radius);
    cover(part, bone->to, bone->to_radius);
    if (side == SOFT_BOTH) {
        struct bone other = *bone;
        other.from[2] = -other.from[2];
        other.to[2] = -other.to[2];
        soft_add_bone(body, frame, &other, SOFT_ONE);
    }
}

static void add_ellipsoid(struct soft_body *body, const struct soft_frame *frame,
                          const struct muscle *muscle, enum soft_side side, bool carve) {
    struct soft_part *part = next_part(body, frame);
    part->muscle = *muscle;
    part->carve = carve;
    /* The part's frame is made of the ellipsoid's axes. */
    float c = cosf(glm_rad(muscle->tilt)), s = sinf(glm_rad(muscle->tilt));
    to_world(frame, muscle->center, part->frame.origin);
    for (int k = 0; k < 3; k++) {
        part->frame.right[k] = c * frame->right[k] + s * frame->up[k];
        part->frame.up[k] = c * frame->up[k] - s * frame->right[k];
    }
    cover(part, (const float[]){0.0f, 0.0f, 0.0f}, glm_vec3_max((float *)muscle->radii));
    if (side == SOFT_BOTH) {
        struct muscle other = *muscle;
        other.center[2] = -other.center[2];
        add_ellipsoid(body, frame, &other, SOFT_ONE, carve);
    }
}

void soft_add_muscle(struct soft_body *body, const struct soft_frame *frame,
                     const struct muscle *muscle, enum soft_side side) {
    add_ellipsoid(body, frame, muscle, side, false);
}

void soft_carve(struct soft_body *body, const struct soft_frame *frame, const struct muscle *muscle,
                enum soft_side side) {
    add_ellipsoid(body, frame, muscle, side, true);
}
