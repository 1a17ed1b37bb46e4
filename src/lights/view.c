#include "lights/view.h"

#include "base/error.h"

#include <cglm/cglm.h>

#include <assert.h>
#include <math.h>
#include <string.h>

static const float near_fraction = 1e-6f; /* of the scene's radius */

/* What origin, right, up and forward say, as a matrix: x over the right edge, y over the top edge,
 * and the reversed depth of shared/view.h. right and up need not be unit. */
static void set_matrix(struct view *view) {
    vec3 right, up;
    glm_vec3_scale(view->right, 1 / glm_vec3_norm2(view->right), right);
    glm_vec3_scale(view->up, 1 / glm_vec3_norm2(view->up), up);
    bool orthographic = view->orthographic;
    const float *rows[] = {right, up, view->forward};
    float at_origin[3];
    for (int i = 0; i < 3; i++)
        at_origin[i] = -glm_vec3_dot((float *)rows[i], view->origin);
    memset(view->world_to_clip, 0, sizeof view->world_to_clip);
    for (int column = 0; column < 4; column++) {
        float *clip = view->world_to_clip[column];
        float z = column < 3 ? view->forward[column] : at_origin[2];
        clip[0] = column < 3 ? right[column] : at_origin[0];
        clip[1] = column < 3 ? up[column] : at_origin[1];
        clip[2] = orthographic ? -z / view->far : 0;
        clip[3] = orthographic ? 0 : z;
    }
    view->world_to_clip[3][2] += orthographic ? 1 : view->near;
    view->world_to_clip[3][3] += orthographic ? 1 : 0;
}

static void set_axes(struct view *view, const float origin[3], const float right[3],
                     const float up[3], const float forward[3], float half_width,
                     float half_height) {
    *view = (struct view){0};
    for (int i = 0; i < 3; i++) {
        view->origin[i] = origin[i];
        view->right[i] = right[i] * half_width;
        view->up[i] = up[i] * half_height;
        view->forward[i] = forward[i];
    }
    view->far = 1;
}

void view_of_camera(struct view *view, const struct camera *camera, const struct geometry *geometry,
                    float aspect) {
    float half = camera->orthographic ? camera->y_extent : tanf(camera->fov_y / 2);
    set_axes(view, camera->eye, camera->right, camera->up, camera->forward, half * aspect, half);
    view->near = near_fraction * geometry->radius;
    if (camera->orthographic) {
        float to_center[3];
        glm_vec3_sub((float *)geometry->center, view->origin, to_center);
        float depth = glm_vec3_dot(to_center, view->forward);
        view->orthographic = true;
        view->far = fmaxf(depth + 1.01f * geometry->radius, geometry->radius);
    }
    set_matrix(view);
    if (camera->shift[0] != 0 || camera->shift[1] != 0) {
        view_shift(view, camera->shift);
        view->leans = !camera->orthographic;
    }
}

/* Of a perspective view the frustum leans, and forward with it; an orthographic one moves. */
void view_shift(struct view *view, const float ndc[2]) {
    float *moved = view->orthographic ? view->origin : view->forward;
    for (int i = 0; i < 3; i++)
        moved[i] += ndc[0] * view->right[i] + ndc[1] * view->up[i];
    for (int column = 0; column < 4; column++)
        for (int axis = 0; axis < 2; axis++)
            view->world_to_clip[column][axis] -= ndc[axis] * view->world_to_clip[column][3];
}

void view_axis(const struct view *view, float axis[3]) {
    for (int i = 0; i < 3; i++)
        axis[i] = view->leans ? view->world_to_clip[i][3] : view->forward[i];
}

/* --- lights --- */

_Static_assert((int)EMITTER_DIRECTIONAL == LIGHT_TYPE_DIRECTIONAL &&
                   (int)EMITTER_AREA == LIGHT_TYPE_AREA && (int)EMITTER_MANY == LIGHT_TYPE_MANY &&
                   (int)EMITTER_IS_CAP == LIGHT_SHAPE_CAP,
               "shaders know types and shapes by the same numbers");

static int view_count(const struct emitter *light) {
    if (light->type == EMITTER_MANY)
        return 0;
    bool narrow = light->type == EMITTER_SPOT && light->cos_outer >= 0.5f;
    return light->type == EMITTER_DIRECTIONAL || narrow ? 1 : 6;
}

/* A light that shines one way has one map of its own. */
static int map_count(const struct emitter *light) {
    return light->type == EMITTER_POINT ? 6 : light->type == EMITTER_MANY ? 0 : 1;
}

void light_layout_count(struct light_layout *layout, const struct emitters *emitters) {
    *layout = (struct light_layout){
        .lights = emitters->count, .groups = emitters->count, .sky = emitters->sky};
    for (int i = 0; i < emitters->count; i++) {
        int views = view_count(&emitters->items[i]);
        layout->views[views > 1 ? LIGHT_MAP_FACE : LIGHT_MAP_SINGLE] += views;
        layout->many |= emitters->items[i].type == EMITTER_MANY;
        layout->maps += map_count(&emitters->items[i]);
        layout->sized |= emitter_shape(&emitters->items[i]) != EMITTER_IS_POINT;
    }
}

static int all_views(const struct light_layout *layout) {
    return layout->views[LIGHT_MAP_SINGLE] + layout->views[LIGHT_MAP_FACE];
}

bool light_layout_fits(const struct light_layout *layout) {
    return layout->lights <= LIGHTS_MAX && all_views(layout) <= LIGHT_VIEWS_MAX;
}

bool light_layout_of(struct light_layout *layout, const struct emitters *emitters) {
    light_layout_count(layout, emitters);
    return light_layout_fits(layout) ||
           error_set(
               "%d lights with %d views: at most %d with %d shine at once; --light picks some",
               layout->lights, all_views(layout), LIGHTS_MAX, LIGHT_VIEWS_MAX);
}

bool light_layouts_same(const struct light_layout *a, const struct light_layout *b) {
    return a->lights == b->lights && a->groups == b->groups && a->maps == b->maps &&
           a->sized == b->sized && a->sky == b->sky && a->many == b->many &&
           a->unseen == b->unseen && memcmp(a->views, b->views, sizeof a->views) == 0;
}

int light_map_size(int kind, int size) {
    return kind == LIGHT_MAP_FACE ? (size + 1) / 2 : size;
}

int light_map_share(int size, int views, int full_views) {
    const int least = 16;
    if (views <= full_views)
        return size;
    int shared = (int)((float)size * sqrtf((float)full_views / (float)views));
    return shared > least ? shared : least;
}

static void set_spot_view(struct view *view, const struct emitter *light) {
    float tangent = sqrtf(1 - light->cos_outer * light->cos_outer) / light->cos_outer;
    /* The cone touches the edges of the map from inside. */
    tangent *= 1.01f;
    set_axes(view, light->position, light->right, light->up, light->direction, tangent, tangent);
}

static void set_face_view(struct view *view, const struct emitter *light, int face) {
    static const float axes[6][3][3] = {
        /* right, up, forward: right x up = -forward */
        {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}},  {{0, 0, -1}, {0, 1, 0}, {-1, 0, 0}},
        {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}},  {{1, 0, 0}, {0, 0, -1}, {0, -1, 0}},
        {{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{1, 0, 0}, {0, 1, 0}, {0, 0, -1}},
    };
    set_axes(view, light->position, axes[face][0], axes[face][1], axes[face][2], 1, 1);
}

/* The smallest rectangle across the light's direction that holds the bounding box. */
static void set_directional_view(struct view *view, const struct emitter *light,
                                 const struct geometry *geometry) {
    const float *axes[3] = {light->right, light->up, light->direction};
    float low[3], high[3], origin[3] = {0};
    for (int a = 0; a < 3; a++) {
        low[a] = high[a] = 0;
        for (int i = 0; i < 3; i++) {
            float x = axes[a][i] * geometry->bounds_min[i],
                  y = axes[a][i] * geometry->bounds_max[i];
            low[a] += fminf(x, y);
            high[a] += fmaxf(x, y);
        }
        float margin = 1e-3f * geometry->radius;
        low[a] -= margin;
        high[a] += margin;
    }
    float middle[3] = {(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, low[2]};
    for (int a = 0; a < 3; a++)
        for (int i = 0; i < 3; i++)
            origin[i] += middle[a] * axes[a][i];
    set_axes(view, origin, light->right, light->up, light->direction, (high[0] - low[0]) / 2,
             (high[1] - low[1]) / 2);
    view->orthographic = true;
    view->far = high[2] - low[2];
}

static void set_view(struct view *view, const struct emitter *light, int face,
                     const struct geometry *geometry) {
    if (light->type == EMITTER_DIRECTIONAL)
        set_directional_view(view, light, geometry);
    else if (view_count(light) == 1)
        set_spot_view(view, light);
    else
        set_face_view(view, light, face);
    view->near = near_fraction * geometry->radius;
    set_matrix(view);
}

void view_of_directional(struct view *view, const struct emitter *light,
                         const struct geometry *geometry) {
    set_view(view, light, 0, geometry);
}

/* What it shines into: solid angle, sr; of a directional light area, m2; of many lights 1. */
static float measure(const struct emitter *light, const struct view *first) {
    return light->type == EMITTER_MANY ? 1
           : light->type == EMITTER_DIRECTIONAL
               ? 4 * glm_vec3_norm((float *)first->right) * glm_vec3_norm((float *)first->up)
               : (float)emitter_solid_angle(light);
}

/* The distance to the farthest corner of the scene. */
static float farthest(const float from[3], const struct geometry *geometry) {
    vec3 away;
    for (int c = 0; c < 3; c++)
        away[c] = fmaxf(fabsf(from[c] - geometry->bounds_min[c]),
                        fabsf(from[c] - geometry->bounds_max[c]));
    return glm_vec3_norm(away);
}

static struct light light_of(const struct emitter *emitter, const struct view *first,
                             const struct geometry *geometry) {
    bool directional = emitter->type == EMITTER_DIRECTIONAL;
    struct light light = {
        .measure = measure(emitter, first),
        .type = emitter->type,
        .cos_inner = emitter->cos_inner,
        .cos_outer = emitter->cos_outer,
        .direct_scale = directional ? 1 : geometry->radius * geometry->radius,
        .view_count = view_count(emitter),
        .shape = (int)emitter_shape(emitter),
        .width = emitter->size[0],
        .height = emitter->size[1],
        .extent = (float)emitter_extent(emitter),
        .map_unit = directional ? first->far : farthest(emitter->position, geometry),
        .range_inverse2 = directional || emitter->range <= 0
                              ? 0
                              : fminf(1 / (emitter->range * emitter->range), 1e30f),
        .slide = -1,
    };
    if (emitter_has_slide(emitter)) {
        light.slide = emitter->slide->layer;
        light.slide_scale = emitter_slide_scale(emitter);
        light.slide_width = (float)emitter->slide->width;
        light.slide_height = (float)emitter->slide->height;
    }
    if (emitter->type == EMITTER_MANY) /* else each pass would shine by it */
        light.extent = emitter->intensity[0];
    for (int c = 0; c < 3; c++) {
        light.intensity[c] = emitter->type == EMITTER_MANY ? 0 : emitter->intensity[c];
        light.position[c] = (directional ? first->origin : emitter->position)[c];
        light.direction[c] = emitter->direction[c];
        light.right[c] = emitter->right[c];
        light.up[c] = emitter->up[c];
        light.radiance[c] = light.intensity[c] / (GLM_PIf * light.direct_scale);
    }
    return light;
}

void views_of_emitters(struct light_block *block, const struct emitters *emitters,
                       const struct geometry *geometry) {
    struct light_layout layout;
    bool fits = light_layout_of(&layout, emitters);
    assert(fits);
    *block = (struct light_block){
        .count = emitters->count,
        .single_count = layout.views[LIGHT_MAP_SINGLE],
        .face_count = layout.views[LIGHT_MAP_FACE],
    };
    int ends[LIGHT_MAP_KINDS] = {0}, maps = 0;
    for (int i = 0; i < emitters->count; i++) {
        const struct emitter *emitter = &emitters->items[i];
        int count = view_count(emitter), kind = count > 1 ? LIGHT_MAP_FACE : LIGHT_MAP_SINGLE;
        int first = ends[kind] + (kind == LIGHT_MAP_FACE ? block->single_count : 0);
        for (int face = 0; face < count; face++) {
            struct light_view *view = &block->views[first + face];
            *view = (struct light_view){.light = i, .kind = kind, .layer = ends[kind]++};
            set_view(&view->view, emitter, face, geometry);
        }
        block->sources[i] = light_of(emitter, &block->views[first].view, geometry);
        block->sources[i].first_view = first;
        block->sources[i].first_map = maps;
        maps += map_count(emitter);
    }
}
