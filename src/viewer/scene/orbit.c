#include "viewer/scene/orbit.h"

#include <math.h>
#include <string.h>

#include "base/unit.h"

static const float steepest = 0.9995F; /* sine of the highest and lowest view */

/* Over the scene's radius. */
static const float nearest = 1e-3F, farthest = 1e3F;

/* Where the view's axis is at the point's distance. */
static void point_ahead(struct orbit *orbit) {
    glm_vec3_copy(orbit->camera.eye, orbit->point);
    glm_vec3_muladds(orbit->camera.forward, orbit->distance, orbit->point);
}

void orbit_grab(struct orbit *orbit, const float point[3]) {
    vec3 to_point;
    glm_vec3_copy((float *)point, orbit->point);
    glm_vec3_sub(orbit->point, orbit->camera.eye, to_point);
    orbit->distance = fmaxf(glm_vec3_dot(to_point, orbit->camera.forward), nearest * orbit->radius);
}

void orbit_start(struct orbit *orbit, const struct camera *camera, const float center[3],
                 float radius) {
    *orbit = (struct orbit){.camera = *camera, .radius = radius, .world_up = {0, 1, 0}};
    vec3 to_center;
    glm_vec3_sub((float *)center, orbit->camera.eye, to_center);
    orbit->distance = fmaxf(glm_vec3_dot(to_center, orbit->camera.forward), .05F * radius);
    /* A camera that looks straight up or down, or lies on its side, keeps its own idea of up. */
    if (fabsf(camera->forward[1]) > steepest || camera->up[1] < .5F)
        memcpy(orbit->world_up, camera->up, sizeof orbit->world_up);
    point_ahead(orbit);
}

/* The forward direction turned, level and never over the top. */
static void turn(struct orbit *orbit, float right_angle, float down_angle) {
    struct camera *camera = &orbit->camera;
    vec3 forward;
    glm_vec3_copy(camera->forward, forward);
    glm_vec3_rotate(forward, -right_angle, orbit->world_up);
    vec3 right;
    glm_vec3_cross(forward, orbit->world_up, right);
    vec3_unit(right);
    float sine = glm_vec3_dot(forward, orbit->world_up);
    float angle = asinf(glm_clamp(sine, -1, 1));
    float limit = asinf(steepest);
    float turned = glm_clamp(angle - down_angle, -limit, limit);
    glm_vec3_rotate(forward, turned - angle, right);
    camera_look(camera, camera->eye, forward, orbit->world_up);
}

void orbit_turn(struct orbit *orbit, float right, float down) {
    struct camera *camera = &orbit->camera;
    vec3 to_point, eye;
    glm_vec3_sub(orbit->point, camera->eye, to_point);
    float across = glm_vec3_dot(to_point, camera->right), up = glm_vec3_dot(to_point, camera->up),
          along = glm_vec3_dot(to_point, camera->forward);
    turn(orbit, (float)GLM_PI * right, (float)GLM_PI * down);
    glm_vec3_copy(orbit->point, eye);
    glm_vec3_muladds(camera->right, -across, eye);
    glm_vec3_muladds(camera->up, -up, eye);
    glm_vec3_muladds(camera->forward, -along, eye);
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
    vec3 by = {0, 0, 0};
    glm_vec3_muladds(camera->right, right, by);
    glm_vec3_muladds(camera->up, up, by);
    glm_vec3_muladds(camera->forward, forward, by);
    glm_vec3_add(camera->eye, by, camera->eye);
    glm_vec3_add(orbit->point, by, orbit->point);
}

void orbit_pan(struct orbit *orbit, float right, float down) {
    float height = picture_height(orbit);
    move(orbit, -right * height, down * height, 0);
}

void orbit_zoom(struct orbit *orbit, float steps) {
    struct camera *camera = &orbit->camera;
    float after = glm_clamp(orbit->distance * powf(.9F, steps), nearest * orbit->radius,
                            farthest * orbit->radius);
    float factor = camera->orthographic ? powf(.9F, steps) : after / orbit->distance;
    vec3 to_point;
    glm_vec3_sub(orbit->point, camera->eye, to_point);
    if (camera->orthographic) {
        /* Sideways alone: what is near must not get behind the eye. */
        camera->y_extent *= factor;
        glm_vec3_muladds(camera->forward, -glm_vec3_dot(to_point, camera->forward), to_point);
    } else {
        orbit->distance = after;
    }
    glm_vec3_muladds(to_point, 1 - factor, camera->eye);
}

void orbit_frame(struct orbit *orbit, const float center[3], float radius, float aspect) {
    struct camera *camera = &orbit->camera;
    const float room = 1.1F; /* around the sphere */
    float half = camera->fov_y / 2;
    if (aspect < 1)
        half = atanf(tanf(half) * aspect);
    orbit->distance = fmaxf(room * radius / sinf(half), nearest * orbit->radius);
    if (camera->orthographic) {
        camera->y_extent = room * radius / fminf(aspect, 1);
        orbit->distance = 2 * radius;
    }
    glm_vec3_copy((float *)center, orbit->point);
    glm_vec3_copy((float *)center, camera->eye);
    glm_vec3_muladds(camera->forward, -orbit->distance, camera->eye);
}

void orbit_look(struct orbit *orbit, float right, float down) {
    float angle = orbit->camera.orthographic ? (float)GLM_PI_2 : orbit->camera.fov_y;
    turn(orbit, angle * right, angle * down);
    point_ahead(orbit);
}

void orbit_fly(struct orbit *orbit, float right, float up, float forward) {
    move(orbit, right * orbit->radius, up * orbit->radius, forward * orbit->radius);
}
