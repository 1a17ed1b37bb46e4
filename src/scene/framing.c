#include "scene/framing.h"

#include "base/log.h"
#include "base/memory.h"
#include "scene/mesh/geometry.h"
#include "scene/node.h"
#include "scene/room.h"

#include <cglm/cglm.h>
#include <stdio.h>
#include <string.h>

static const float fov_y = 0.7F, fov_y_in_room = 1.1F;

/* Appends a node that stands at eye and looks along -Z at the target. */
static struct node *add_node(struct scene *scene, const char *name, vec3 eye, vec3 target) {
    scene->nodes = mem_resize(scene->nodes, (size_t)scene->node_count + 1, sizeof *scene->nodes);
    struct node *node = &scene->nodes[scene->node_count++];
    *node = (struct node){.parent = -1,
                          .mesh = -1,
                          .light = -1,
                          .camera = -1,
                          .skin = -1,
                          .metaballs = -1,
                          .has_matrix = true};
    snprintf(node->name, sizeof node->name, "%s", name);
    mat4 view, world;
    glm_lookat(eye, target, (vec3){0, 1, 0}, view);
    glm_mat4_inv(view, world);
    memcpy(node->matrix, world, sizeof node->matrix);
    return node;
}

/* A point on the line from the scene's centre in a direction, at a distance in radii. */
static void point_around(const struct geometry *geometry, vec3 direction, float radii, vec3 out) {
    vec3 unit;
    glm_vec3_normalize_to(direction, unit);
    glm_vec3_copy((float *)geometry->center, out);
    glm_vec3_muladds(unit, radii * geometry->radius, out);
}

/* How far from the centre a camera in that direction just sees all corners of the bounds in a
 * square picture: a corner at (x, y, z) in its frame needs |x|, |y| <= (distance - z) tan(fov / 2).
 */
static float fitting_distance(const struct geometry *geometry, vec3 direction) {
    mat4 view;
    glm_lookat(direction, (vec3){0, 0, 0}, (vec3){0, 1, 0}, view);
    float distance = geometry->radius;
    for (int corner = 0; corner < 8; corner++) {
        vec3 offset, seen;
        for (int c = 0; c < 3; c++)
            offset[c] = (corner >> c & 1 ? geometry->bounds_max : geometry->bounds_min)[c] -
                        geometry->center[c];
        glm_mat4_mulv3(view, offset, 0, seen);
        float across = fmaxf(fabsf(seen[0]), fabsf(seen[1]));
        distance = fmaxf(distance, across / tanf(fov_y / 2) + seen[2]);
    }
    return distance;
}

static void place_camera(const struct geometry *geometry, const struct room *room, vec3 eye,
                         vec3 target) {
    const float margin = 1.05F, step_from_wall = .9F;
    vec3 direction = {.6F, .45F, 1};
    point_around(geometry, direction,
                 margin * fitting_distance(geometry, direction) / geometry->radius, eye);
    point_around(geometry, direction, 0, target);
    if (!room)
        return;
    glm_vec3_copy(target, eye);
    glm_vec3_muladds((float *)room->forward, -step_from_wall * room->behind, eye);
    glm_vec3_muladds((float *)room->forward, room->ahead, target);
}

static void add_camera(struct scene *scene, const struct geometry *geometry,
                       const struct room *room) {
    vec3 eye, target;
    place_camera(geometry, room, eye, target);
    struct node *node = add_node(scene, "framed camera", eye, target);
    scene->cameras =
        mem_resize(scene->cameras, (size_t)scene->camera_count + 1, sizeof *scene->cameras);
    struct scene_camera *camera = &scene->cameras[scene->camera_count];
    *camera = (struct scene_camera){.fov_y = room ? fov_y_in_room : fov_y,
                                    .near = .01F * geometry->radius,
                                    .far = 10 * geometry->radius};
    snprintf(camera->name, sizeof camera->name, "framed");
    node->camera = scene->camera_count++;
    log_note("%s: no camera, so one that frames the scene", scene->path);
}

/* The spot is as wide as the bounding sphere, or shines down from a room's ceiling, and gives the
 * centre, or there the floor, an irradiance of pi: a white surface that faces it has radiance 1. */
static void add_spot(struct scene *scene, const struct geometry *geometry,
                     const struct room *room) {
    const float radii = 2.5F, outer = room ? .9F : asinf(1 / radii);
    vec3 eye, target;
    point_around(geometry, (vec3){.2F, 1.2F, 1}, radii, eye);
    point_around(geometry, (vec3){0, 1, 0}, 0, target);
    if (room) {
        glm_vec3_copy(target, eye);
        eye[1] += .9F * room->up;
        target[1] -= room->up;
        eye[2] += .01F * room->up; /* not straight down: the light's frame has an up */
    }
    struct node *node = add_node(scene, "framed spot", eye, target);
    scene->lights =
        mem_resize(scene->lights, (size_t)scene->light_count + 1, sizeof *scene->lights);
    struct scene_light *light = &scene->lights[scene->light_count];
    float intensity = GLM_PIf * glm_vec3_distance2(eye, target);
    *light = (struct scene_light){.type = EMITTER_SPOT,
                                  .intensity = {intensity, intensity, intensity},
                                  .inner = .8F * outer,
                                  .outer = outer,
                                  .range = INFINITY};
    snprintf(light->name, sizeof light->name, "framed");
    node->light = scene->light_count++;
    log_note("%s: no light, so a spot from above", scene->path);
}

bool scene_frame(struct scene *scene) {
    bool camera = node_count_carrying(scene, NODE_CAMERA) > 0;
    bool light = node_count_carrying(scene, NODE_LIGHT) > 0;
    if (camera && light)
        return true;
    struct geometry geometry;
    if (!geometry_init_still(&geometry, scene, 0))
        return false;
    struct room around, *room = room_around(&around, &geometry, geometry.center) ? &around : NULL;
    if (!camera)
        add_camera(scene, &geometry, room);
    if (!light)
        add_spot(scene, &geometry, room);
    geometry_free(&geometry);
    return true;
}
