#include "viewer/orbit.h"

#include <cglm/cglm.h>

#include <math.h>
#include <string.h>

static const float steepest = 0.9995F; /* sine of the highest and lowest view */

void orbit_start(struct orbit *orbit, const struct camera *camera, const float center[3],
                 float radius) {
    *orbit = (struct orbit){.camera = *camera, .radius = radius, .world_up = {0, 1, 0}};
    vec3 to_center;
    glm_vec3_sub((float *)center, orbit->camera.eye, to_center);
    orbit->distance = fmaxf(glm_vec3_dot(to_center, orbit->camera.forward), .05F * radius);
    /* A camera that looks straight up or down, or lies on its side, keeps its own idea of up. */
    if (fabsf(camera->forward[1]) > steepest || camera->up[1] < .5F)
        memcpy(orbit->world_up, camera->up, sizeof orbit->world_up);
}

static void point_of(const struct orbit *orbit, vec3 point) {
    glm_vec3_copy((float *)orbit->camera.eye, point);
    glm_vec3_muladds((float *)orbit->camera.forward, orbit->distance, point);
}

/* The forward direction turned, level and never over the top. */
static void turn(struct orbit *orbit, float right_angle, float down_angle) {
    struct camera *camera = &orbit->camera;
    vec3 forward;
    glm_vec3_copy(camera->forward, forward);
    glm_vec3_rotate(forward, -right_angle, orbit->world_up);
    vec3 right;
    glm_vec3_cross(forward, orbit->world_up, right);
    glm_vec3_normalize(right);
    float sine = glm_vec3_dot(forward, orbit->world_up);
    float angle = asinf(glm_clamp(sine, -1, 1));
    float limit = asinf(steepest);
    float turned = glm_clamp(angle - down_angle, -limit, limit);
    glm_vec3_rotate(forward, turned - angle, right);
    camera_look(camera, camera->eye, forward, orbit->world_up);
}

void orbit_turn(struct orbit *orbit, float right, float down) {
    struct camera *camera = &orbit->camera;
    vec3 point, eye;
    point_of(orbit, point);
    turn(orbit, (float)GLM_PI * right, (float)GLM_PI * down);
    glm_vec3_copy(point, eye);
    glm_vec3_muladds(camera->forward, -orbit->distance, eye);
    camera_look(camera, eye, camera->forward, orbit->world_up);
}

/* Metres across the picture's height, where the point lies. */
static float picture_height(const struct orbit *orbit) {
    const struct camera *camera = &orbit->camera;
    return camera->orthographic ? 2 * camera->y_extent
                                : 2 * tanf(camera->fov_y / 2) * orbit->distance;
}

static void move(struct orbit *orbit, float right, float up, float forward) {
    struct camera *camera = &orbit->camera;
    glm_vec3_muladds(camera->right, right, camera->eye);
    glm_vec3_muladds(camera->up, up, camera->eye);
    glm_vec3_muladds(camera->forward, forward, camera->eye);
}

void orbit_pan(struct orbit *orbit, float right, float down) {
    float height = picture_height(orbit);
    move(orbit, -right * height, down * height, 0);
}

void orbit_zoom(struct orbit *orbit, float steps) {
    float factor = powf(.9F, steps), before = orbit->distance;
    if (orbit->camera.orthographic) {
        orbit->camera.y_extent *= factor;
        return;
    }
    orbit->distance = glm_clamp(before * factor, 1e-3F * orbit->radius, 1e3F * orbit->radius);
    move(orbit, 0, 0, before - orbit->distance);
}

void orbit_look(struct orbit *orbit, float right, float down) {
    float angle = orbit->camera.orthographic ? (float)GLM_PI_2 : orbit->camera.fov_y;
    turn(orbit, angle * right, angle * down);
}

void orbit_fly(struct orbit *orbit, float right, float up, float forward) {
    move(orbit, right * orbit->radius, up * orbit->radius, forward * orbit->radius);
}
