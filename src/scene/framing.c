#include "scene/framing.h"

#include "base/log.h"
#include "base/memory.h"
#include "scene/node.h"
#include "scene/room.h"

#include <cglm/cglm.h>
#include <stdio.h>
#include <string.h>

static const float fov_y = 0.7F, fov_y_in_room = 1.1F;

/* Appends a node; its place follows. */
static int add_node(struct scene *scene, const char *name) {
    scene->nodes = mem_resize(scene->nodes, (size_t)scene->node_count + 1, sizeof *scene->nodes);
    struct node *node = &scene->nodes[scene->node_count];
    *node = (struct node){.parent = -1,
                          .mesh = -1,
                          .light = -1,
                          .camera = -1,
                          .skin = -1,
                          .metaballs = -1,
                          .has_matrix = true};
    snprintf(node->name, sizeof node->name, "%s", name);
    glm_mat4_identity((vec4 *)node->matrix);
    return scene->node_count++;
}

static int add_camera(struct scene *scene) {
    int node = add_node(scene, "framed camera");
    scene->cameras =
        mem_resize(scene->cameras, (size_t)scene->camera_count + 1, sizeof *scene->cameras);
    scene->cameras[scene->camera_count] = (struct scene_camera){.name = "framed"};
    scene->nodes[node].camera = scene->camera_count++;
    log_note("%s: no camera, so one that frames the scene", scene->path);
    return node;
}

static int add_spot(struct scene *scene) {
    int node = add_node(scene, "framed spot");
    scene->lights =
        mem_resize(scene->lights, (size_t)scene->light_count + 1, sizeof *scene->lights);
    scene->lights[scene->light_count] =
        (struct scene_light){.name = "framed", .type = EMITTER_SPOT, .range = INFINITY};
    scene->nodes[node].light = scene->light_count++;
    log_note("%s: no light, so a spot from above", scene->path);
    return node;
}

void framing_add(struct framing *framing, struct scene *scene) {
    framing->camera = node_count_carrying(scene, NODE_CAMERA) ? -1 : add_camera(scene);
    bool has_light = node_count_carrying(scene, NODE_LIGHT) || scene->environment;
    framing->light = has_light ? -1 : add_spot(scene);
}

/* --- places ----------------------------------------------------------------------------------- */

/* Stands at eye and looks along -Z at the target. */
static void place_node(struct node *node, vec3 eye, vec3 target) {
    mat4 view, world;
    glm_lookat(eye, target, (vec3){0, 1, 0}, view);
    glm_mat4_inv(view, world);
    memcpy(node->matrix, world, sizeof node->matrix);
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

static void place_camera(struct scene *scene, struct node *node, const struct geometry *geometry,
                         const struct room *room) {
    const float margin = 1.05F, step_from_wall = .9F;
    vec3 direction = {.6F, .45F, 1}, eye, target;
    point_around(geometry, direction,
                 margin * fitting_distance(geometry, direction) / geometry->radius, eye);
    point_around(geometry, direction, 0, target);
    if (room) {
        glm_vec3_copy(target, eye);
        glm_vec3_muladds((float *)room->forward, -step_from_wall * room->behind, eye);
        glm_vec3_muladds((float *)room->forward, room->ahead, target);
    }
    place_node(node, eye, target);
    scene->cameras[node->camera].fov_y = room ? fov_y_in_room : fov_y;
}

/* The spot is as wide as the bounding sphere, or shines down from a room's ceiling, and gives the
 * centre, or there the floor, an irradiance of pi: a white surface that faces it has radiance 1. */
static void place_spot(struct scene *scene, struct node *node, const struct geometry *geometry,
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
    place_node(node, eye, target);
    struct scene_light *light = &scene->lights[node->light];
    glm_vec3_broadcast(GLM_PIf * glm_vec3_distance2(eye, target), light->intensity);
    light->inner = .8F * outer;
    light->outer = outer;
}

void framing_place(const struct framing *framing, struct scene *scene,
                   const struct geometry *geometry) {
    if (framing->camera < 0 && framing->light < 0)
        return;
    struct room around, *room = room_around(&around, geometry, geometry->center) ? &around : NULL;
    if (framing->camera >= 0)
        place_camera(scene, &scene->nodes[framing->camera], geometry, room);
    if (framing->light >= 0)
        place_spot(scene, &scene->nodes[framing->light], geometry, room);
}
