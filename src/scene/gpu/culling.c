#include "scene/gpu/culling.h"

#include "base/memory.h"

#include <cglm/cglm.h>
#include <float.h>
#include <math.h>
#include <stdlib.h>

/* Indices of a run. Fewer follow what is seen more closely, and are more draws. */
enum { RUN = 3 * 128 };

static uint32_t least(uint32_t a, uint32_t b) {
    return a < b ? a : b;
}

static void measure_run(const struct culling *culling, const struct geometry *geometry,
                        uint32_t run) {
    float *low = culling->boxes[run][0], *high = culling->boxes[run][1];
    glm_vec3_broadcast(FLT_MAX, low);
    glm_vec3_broadcast(-FLT_MAX, high);
    for (uint32_t k = run * RUN; k < least((run + 1) * RUN, geometry->index_count); k++) {
        float *position = geometry->position[geometry->indices[k]];
        glm_vec3_minv(low, position, low);
        glm_vec3_maxv(high, position, high);
    }
}

void culling_init(struct culling *culling, const struct geometry *geometry) {
    culling->runs = (geometry->index_count + RUN - 1) / RUN;
    culling->boxes = mem_alloc(culling->runs, sizeof *culling->boxes);
    culling_measure(culling, geometry, 0, geometry->index_count);
}

void culling_free(struct culling *culling) {
    free(culling->boxes);
    *culling = (struct culling){0};
}

void culling_measure(const struct culling *culling, const struct geometry *geometry, uint32_t first,
                     uint32_t count) {
    for (uint32_t run = first / RUN; run * RUN < first + count; run++)
        measure_run(culling, geometry, run);
}

/* Of what is seen -w <= x, y <= w and 0 <= z <= w in clip space [Gribb and Hartmann 2001]. */
static void view_planes(const struct view *view, float margin, float planes[6][4]) {
    for (int c = 0; c < 4; c++) {
        const float *column = view->world_to_clip[c];
        for (int axis = 0; axis < 3; axis++) {
            float low = axis < 2 ? 1 : 0;
            planes[2 * axis][c] = (low + margin) * column[3] + column[axis];
            planes[2 * axis + 1][c] = (1 + margin) * column[3] - column[axis];
        }
    }
}

/* Whether some of the box lies before the plane, as far as rounding tells. */
static bool reaches(const float plane[4], float (*box)[3]) {
    float sum = plane[3], size = fabsf(sum);
    for (int c = 0; c < 3; c++) {
        float term = plane[c] * box[plane[c] > 0][c];
        sum += term;
        size += fabsf(term);
    }
    return sum >= -8 * FLT_EPSILON * size;
}

static bool view_sees(const struct view *view, float margin, float (*box)[3]) {
    float planes[6][4];
    view_planes(view, margin, planes);
    for (int i = 0; i < 6; i++)
        if (!reaches(planes[i], box))
            return false;
    return true;
}

static const struct view *view_at(const struct draw_views *views, int i) {
    return (const struct view *)((const char *)views->first + (size_t)i * views->stride);
}

struct draw_views draw_views_only(const struct draw_views *views, int i) {
    struct draw_views only = *views;
    only.count = 1;
    only.first = view_at(views, i);
    only.first_view += i;
    return only;
}

static int view_count(const struct draw_views *views) {
    return views->stride ? views->count : 1;
}

static bool views_see(const struct draw_views *views, float (*box)[3]) {
    for (int i = 0; i < view_count(views); i++)
        if (view_sees(view_at(views, i), views->margin, box))
            return true;
    return false;
}

/* Half the picture's width at the box's nearest point, metres; 0 behind the view. */
static float half_width(const struct view *view, float (*box)[3]) {
    float nearest = 0;
    if (view->orthographic)
        return glm_vec3_norm((float *)view->right);
    for (int c = 0; c < 3; c++)
        nearest += view->forward[c] * (box[view->forward[c] < 0][c] - view->origin[c]);
    return fmaxf(nearest, 0) * glm_vec3_norm((float *)view->right);
}

int culling_level(const struct draw_views *views, float (*box)[3], const float *errors, int count) {
    int coarsest = -1;
    if (views->coarseness <= 0)
        return 0;
    for (int i = 0; i < view_count(views); i++) {
        const struct view *view = view_at(views, i);
        if (!view_sees(view, views->margin, box))
            continue;
        int level = 0;
        for (int l = 0; l < count; l++)
            if (errors[l] <= views->coarseness * half_width(view, box))
                level = l + 1;
        coarsest = coarsest < 0 || level < coarsest ? level : coarsest;
    }
    return coarsest;
}

bool culling_next(const struct culling *culling, const struct draw_views *views, uint32_t *at,
                  uint32_t end, uint32_t *first, uint32_t *count) {
    uint32_t next = *at;
    while (next < end && !views_see(views, culling->boxes[next / RUN]))
        next = (next / RUN + 1) * RUN;
    *first = next;
    while (next < end && views_see(views, culling->boxes[next / RUN]))
        next = (next / RUN + 1) * RUN;
    *at = least(next, end);
    *count = *at - least(*first, end);
    return *count > 0;
}
