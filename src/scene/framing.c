#include "scene/framing.h"

#include "base/log.h"
#include "base/memory.h"
#include "base/unit.h"
#include "scene/camera.h"
#include "scene/node.h"
#include "scene/room.h"

#include <stdio.h>
#include <string.h>

static const char spot_name[] = "framed spot", fill_name[] = "framed fill";
static const float fov_y = 0.7F, fov_y_in_room = 1.1F;

/* Appends a node; its place follows. */
static int add_node(struct scene *scene, const char *name) {
    scene->nodes = mem_resize(scene->nodes, (size_t)scene->node_count + 1, sizeof *scene->nodes);
    struct node *node = &scene->nodes[scene->node_count];
    *node = node_new();
    node->has_matrix = true;
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

/* A light that a camera of the file's carries goes where that goes. */
static int add_light(struct scene *scene, const char *name, int carrier) {
    int node = add_node(scene, name);
    scene->lights =
        mem_resize(scene->lights, (size_t)scene->light_count + 1, sizeof *scene->lights);
    scene->lights[scene->light_count] =
        (struct scene_light){.type = EMITTER_SPOT, .range = INFINITY};
    snprintf(scene->lights[scene->light_count].name, SCENE_NAME_SIZE, "%s", name);
    scene->nodes[node].parent = carrier;
    scene->nodes[node].light = scene->light_count++;
    return node;
}

static void add_lights(struct framing *framing, struct scene *scene) {
    int carrier = framing->camera < 0 ? node_carrying(scene, NODE_CAMERA, 0) : -1;
    framing->light = add_light(scene, spot_name, carrier);
    framing->fill = add_light(scene, fill_name, carrier);
}

bool framing_made_light(const struct scene *scene, int n) {
    const char *name = scene->nodes[node_carrying(scene, NODE_LIGHT, n)].name;
    return strcmp(name, spot_name) == 0 || strcmp(name, fill_name) == 0;
}

void framing_add(struct framing *framing, struct scene *scene, bool wants_light) {
    *framing = (struct framing){-1, -1, -1};
    if (!node_count_carrying(scene, NODE_CAMERA))
        framing->camera = add_camera(scene);
    if (!wants_light || node_count_carrying(scene, NODE_LIGHT) || scene->environment)
        return;
    add_lights(framing, scene);
    log_note("%s: no light, so a spot from above, and a dim one", scene->path);
}

void framing_add_lights(struct framing *framing, struct scene *scene) {
    add_lights(framing, scene);
    log_note(
        "%s: its own lights leave the picture dark, so a spot from above is added, and a dim one; "
        "--light emitters adds none",
        scene->path);
}

/* --- places ----------------------------------------------------------------------------------- */

/* Stands at eye and looks along -Z in a direction, whatever carries it. */
static void place_node(struct scene *scene, int index, vec3 eye, vec3 direction) {
    struct node *node = &scene->nodes[index];
    mat4 view, world, carrier;
    bool upright = fabsf(direction[1]) > .999F * glm_vec3_norm(direction);
    glm_look(eye, direction, upright ? (vec3){0, 0, 1} : (vec3){0, 1, 0}, view);
    glm_mat4_inv(view, world);
    if (node->parent >= 0) {
        node_world(scene, node->parent, 0, (float *)carrier);
        if (fabsf(glm_mat4_det(carrier)) > 1e-12F) {
            glm_mat4_inv(carrier, carrier);
            glm_mat4_mul(carrier, world, world);
        } else
            node->parent = -1; /* what has no size carries nothing */
    }
    memcpy(node->matrix, world, sizeof node->matrix);
}

/* A point on the line from the scene's centre in a direction, at a distance in radii. */
static void point_around(const struct geometry *geometry, vec3 direction, float radii, vec3 out) {
    vec3 unit;
    vec3_unit_to(direction, unit);
    glm_vec3_copy((float *)geometry->center, out);
    glm_vec3_muladds(unit, radii * geometry->radius, out);
}

/* How far from the centre a camera in that direction just sees all corners of the bounds in a
 * square picture: a corner at (x, y, z) in its frame needs |x|, |y| <= (distance - z) tan(fov
 * / 2). */
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

static void place_camera(struct scene *scene, int node, const struct geometry *geometry,
                         const struct room *room) {
    const float margin = 1.05F, step_from_wall = .9F;
    vec3 back = {.6F, .45F, 1}, eye, forward;
    if (room) {
        glm_vec3_copy((float *)room->at, eye);
        glm_vec3_muladds((float *)room->forward, -step_from_wall * room->behind, eye);
        glm_vec3_copy((float *)room->forward, forward);
    } else {
        point_around(geometry, back, margin * fitting_distance(geometry, back) / geometry->radius,
                     eye);
        glm_vec3_negate_to(back, forward);
    }
    place_node(scene, node, eye, forward);
    scene->cameras[scene->nodes[node].camera].fov_y = room ? fov_y_in_room : fov_y;
}

/* --- lights ----------------------------------------------------------------------------------- */

/* What a white surface that faces the light has as its radiance. */
static const float bright = 1, dim = .15F;

static struct scene_light *light_of(struct scene *scene, int node) {
    return &scene->lights[scene->nodes[node].light];
}

/* From above, a little to the left of where the camera looks: all of the bounding sphere is in the
 * even part of the cone, and more in the rest. */
static void place_spot(struct scene *scene, int node, const struct geometry *geometry,
                       const struct camera *camera) {
    const float radii = 2.5F;
    vec3 back = {-camera->forward[0], 0, -camera->forward[2]}, eye, forward;
    vec3_unit(back);
    glm_vec3_muladds((float *)camera->right, -.3F, back);
    back[1] += 1;
    point_around(geometry, back, radii, eye);
    glm_vec3_negate_to(back, forward);
    place_node(scene, node, eye, forward);
    struct scene_light *light = light_of(scene, node);
    glm_vec3_broadcast(GLM_PIf * bright * glm_vec3_distance2(eye, (float *)geometry->center),
                       light->intensity);
    light->inner = asinf(1 / radii);
    light->outer = 1.3F * light->inner;
}

/* From behind the camera, its right and above, so that what it sees is not black. */
static void place_fill(struct scene *scene, int node, const struct geometry *geometry,
                       const struct camera *camera) {
    vec3 forward;
    glm_vec3_copy((float *)camera->forward, forward);
    glm_vec3_muladds((float *)camera->right, -.4F, forward);
    forward[1] -= .4F;
    place_node(scene, node, (float *)geometry->center, forward);
    struct scene_light *light = light_of(scene, node);
    light->type = EMITTER_DIRECTIONAL;
    glm_vec3_broadcast(GLM_PIf * dim, light->intensity);
}

/* One below the ceiling, down, which gives the floor what a scene's centre has; the dim one lower,
 * all around. */
static void place_in_room(struct scene *scene, const struct framing *framing,
                          const struct room *room) {
    vec3 eye, down = {0, -1, 0};
    glm_vec3_copy((float *)room->at, eye);
    eye[1] += .9F * room->up;
    place_node(scene, framing->light, eye, down);
    struct scene_light *spot = light_of(scene, framing->light),
                       *fill = light_of(scene, framing->fill);
    glm_vec3_broadcast(GLM_PIf * bright * powf(room->down + .9F * room->up, 2), spot->intensity);
    spot->outer = .9F;
    spot->inner = .8F * spot->outer;
    eye[1] -= .6F * room->up;
    place_node(scene, framing->fill, eye, down);
    fill->type = EMITTER_POINT;
    glm_vec3_broadcast(GLM_PIf * dim * room->up * room->ahead, fill->intensity);
}

/* About the place where the camera of the file stands, if it is within a room, or where
 * ours would. */
static void place_lights(struct scene *scene, const struct framing *framing,
                         const struct geometry *geometry, const struct room *found) {
    struct camera camera;
    struct room around;
    const struct room *room = found;
    camera_place(&camera, scene, 0, 0);
    if (framing->camera < 0 && room_around(&around, geometry, camera.eye))
        room = &around;
    else if (room) /* a camera that turns would swing them through its walls */
        scene->nodes[framing->light].parent = scene->nodes[framing->fill].parent = -1;
    if (room) {
        place_in_room(scene, framing, room);
        return;
    }
    place_spot(scene, framing->light, geometry, &camera);
    place_fill(scene, framing->fill, geometry, &camera);
}

void framing_place(const struct framing *framing, struct scene *scene,
                   const struct geometry *geometry) {
    if (framing->camera < 0 && framing->light < 0)
        return;
    struct room found, *room = room_find(&found, geometry) ? &found : NULL;
    if (framing->camera >= 0)
        place_camera(scene, framing->camera, geometry, room);
    if (framing->light >= 0)
        place_lights(scene, framing, geometry, room);
}
