#include "scene/view.h"

#include <cglm/cglm.h>

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
}

int emitter_view_count(const struct emitter *light) {
    bool narrow = light->type == EMITTER_SPOT && light->cos_outer >= 0.5f;
    return light->type == EMITTER_DIRECTIONAL || narrow ? 1 : 6;
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

void view_of_emitter(struct light_block *block, const struct emitter *light,
                     const struct geometry *geometry) {
    *block = (struct light_block){0};
    int count = emitter_view_count(light);
    for (int i = 0; i < count; i++) {
        struct view *view = &block->views[i];
        if (light->type == EMITTER_DIRECTIONAL)
            set_directional_view(view, light, geometry);
        else if (count == 1)
            set_spot_view(view, light);
        else
            set_face_view(view, light, i);
        view->near = near_fraction * geometry->radius;
        set_matrix(view);
    }
    const struct view *first = &block->views[0];
    glm_vec3_copy((float *)light->intensity, block->intensity);
    block->measure = light->type == EMITTER_DIRECTIONAL ? 4 * glm_vec3_norm((float *)first->right) *
                                                              glm_vec3_norm((float *)first->up)
                                                        : (float)emitter_solid_angle(light);
    glm_vec3_copy((float *)(light->type == EMITTER_DIRECTIONAL ? first->origin : light->position),
                  block->position);
    block->type = light->type;
    glm_vec3_copy((float *)light->direction, block->direction);
    block->view_count = count;
    glm_vec3_copy((float *)light->right, block->right);
    block->cos_inner = light->cos_inner;
    glm_vec3_copy((float *)light->up, block->up);
    block->cos_outer = light->cos_outer;
    block->direct_scale =
        light->type == EMITTER_DIRECTIONAL ? 1 : geometry->radius * geometry->radius;
}
