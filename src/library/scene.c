#include "library/scene.h"

#include "base/error.h"
#include "base/file/piped_file.h"
#include "base/memory.h"
#include "base/option.h"
#include "library/arrays.h"
#include "library/desc.h"
#include "library/door.h"
#include "scene/cryptomatte.h"
#include "scene/gltf/gltf.h"
#include "scene/lens.h"
#include "scene/placing.h"
#include "scene/read_rules.h"
#include "scene/surface_layers.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* --- opening ---------------------------------------------------------------------------------- */

static bool refuse(const char *reason) {
    error_set("%s", reason);
    return door_blame(MANYLIGHT_BAD_ARGUMENT);
}

static bool check_sources(const struct manylight_scene_desc *desc) {
    if (desc->mesh_count > 0 && (desc->scene || desc->variant))
        return refuse("manylight_scene_desc: it has meshes, and scene or variant of a file");
    int count = (desc->memory ? 1 : desc->path != NULL) + (desc->mesh_count > 0);
    if (count == 0)
        return refuse("a scene needs a path, memory or meshes");
    if (count > 1)
        return refuse("manylight_scene_desc: it has meshes and a file");
    /* What a pipe holds is kept as long as the process lives. */
    if (desc->path && !desc->memory && piped_file_is(desc->path)) {
        error_set("%s: it is a pipe; give its bytes as memory", desc->path);
        return door_blame(MANYLIGHT_BAD_ARGUMENT);
    }
    return (desc_check("environment_turn", (double)desc->environment_turn, -INFINITY, INFINITY) &&
            (desc->environment_strength == 0 ||
             desc_check("environment_strength", (double)desc->environment_strength, 1e-9, 1e9)) &&
            (desc->punctual_scale == 0 ||
             desc_check("punctual_scale", (double)desc->punctual_scale, 1e-9, 1e9))) ||
           door_blame(MANYLIGHT_BAD_ARGUMENT);
}

static bool open_stage(struct manylight_scene *scene, const struct manylight_scene_desc *desc,
                       struct scene *filled) {
    struct stage_desc stage = {
        .path = filled->path,
        .filled = filled,
        .light = scene->light,
        .clip = desc->clip,
        .environment = {desc->environment, desc->environment_turn,
                        desc->environment_strength == 0 ? 1 : desc->environment_strength},
        .punctual_scale = desc->punctual_scale};
    return stage_init(&scene->stage, &stage);
}

static bool read_scene(struct manylight_scene *scene, const struct manylight_scene_desc *desc) {
    const struct file_bytes bytes = {(unsigned char *)(uintptr_t)desc->memory, desc->memory_bytes};
    const struct scene_choice choice = {desc->scene, desc->variant};
    struct scene filled = {0};
    bool ok = desc->mesh_count > 0 ? arrays_fill(desc, &filled)
                                   : gltf_load(&filled, desc->path ? desc->path : "memory",
                                               bytes.data ? &bytes : NULL, &choice);
    original_keep(&scene->original, &filled);
    if (desc->environment) {
        scene->original.turn = 0;
        scene->original.strength = 1;
    }
    ok = ok && open_stage(scene, desc, &filled);
    scene_free(&filled);
    return ok;
}

static void take_vector(float to[3], const float from[3]) {
    memcpy(to, from, 3 * sizeof *to);
}

static double duration_of(const struct scene *scene) {
    double most = 0;
    for (int i = 0; i < scene->playing_count; i++)
        most = fmax(most, (double)scene->clips[scene->playing[i]].duration);
    return most;
}

void scene_describe(struct manylight_scene *scene) {
    const struct scene *from = &scene->stage.scene;
    const struct geometry *geometry = &scene->stage.geometry;
    struct manylight_scene_info *info = &scene->info;
    *info = (struct manylight_scene_info){.triangle_count = (int)geometry_triangle_count(geometry),
                                          .material_count = from->material_count,
                                          .light_count = emitter_node_count(from),
                                          .camera_count = camera_node_count(from),
                                          .radius = geometry->radius,
                                          .duration = duration_of(from)};
    take_vector(info->center, geometry->center);
    memcpy(info->origin, from->origin, sizeof info->origin);
}

static bool open_scene(const struct manylight_scene_desc *given, struct manylight_scene **out) {
    struct manylight_scene_desc desc;
    struct read_rules rules;
    if (!desc_take(&desc, sizeof desc, given, "manylight_scene_desc") || !check_sources(&desc) ||
        !read_rules_init(&rules, desc.strict != 0, desc.root))
        return false;
    struct manylight_scene *scene = mem_alloc(1, sizeof *scene);
    scene->light = desc.light ? mem_strdup(desc.light) : NULL;
    read_rules_use(&rules);
    bool ok = read_scene(scene, &desc);
    read_rules_use(NULL);
    free(rules.root);
    if (!ok) {
        original_free(&scene->original);
        mem_free(scene->light, scene);
        return false;
    }
    scene_describe(scene);
    atomic_init(&scene->users, 1);
    pthread_mutex_init(&scene->mutex, NULL);
    *out = scene;
    return true;
}

enum manylight_status manylight_scene_open(const struct manylight_scene_desc *desc,
                                           struct manylight_scene **scene) {
    struct door door;
    *scene = NULL;
    door_enter(&door);
    return door_leave(&door, open_scene(desc, scene), MANYLIGHT_BAD_SCENE);
}

/* --- sharing ---------------------------------------------------------------------------------- */

static struct manylight_scene *hold(const struct manylight_scene *scene) {
    struct manylight_scene *held = (struct manylight_scene *)(uintptr_t)scene;
    atomic_fetch_add(&held->users, 1);
    return held;
}

/* The last user ends it. */
static void release(struct manylight_scene *scene) {
    if (!scene || atomic_fetch_sub(&scene->users, 1) > 1)
        return;
    stage_free(&scene->stage);
    original_free(&scene->original);
    free(scene->light);
    pthread_mutex_destroy(&scene->mutex);
    free(scene);
}

void manylight_scene_free(struct manylight_scene *scene) {
    struct door door;
    door_enter(&door);
    release(scene);
    door_leave(&door, true, MANYLIGHT_OK);
}

/* The scene's stage, with its triangles unless another user has them. */
static struct loan lend(struct manylight_scene *scene) {
    pthread_mutex_lock(&scene->mutex);
    struct loan loan = {.from = scene,
                        .stage = scene->stage,
                        .has_original = !scene->is_lent,
                        .edition = scene->edition};
    scene->is_lent = true;
    pthread_mutex_unlock(&scene->mutex);
    return loan;
}

/* Triangles go back as they were at time 0, and a pose that came to be after them is put right by
 * the next user. Those of before a change are freed, as copies are. */
static void take_back(struct loan *loan) {
    struct manylight_scene *scene = loan->from;
    struct geometry *geometry = &loan->stage.geometry;
    emitters_free(&loan->stage.emitters);
    pthread_mutex_lock(&scene->mutex);
    if (loan->has_original && loan->edition == scene->edition) {
        scene->stage.geometry = *geometry;
        scene->is_lent = false;
    } else {
        geometry_free(geometry);
    }
    pthread_mutex_unlock(&scene->mutex);
    *loan = (struct loan){.from = scene};
}

static bool fill_loan(struct loan *loan) {
    *loan = lend(loan->from);
    struct stage *stage = &loan->stage;
    stage->emitters = (struct emitters){0};
    stage->light_text = loan->from->light;
    stage->camera_text = NULL;
    if (!loan->has_original)
        stage->geometry = (struct geometry){0};
    bool ok = (loan->has_original || geometry_init(&stage->geometry, &stage->scene, 0)) &&
              stage_pose(stage, 0);
    if (!ok)
        take_back(loan);
    return ok;
}

bool loan_take(struct loan *loan, const struct manylight_scene *scene) {
    *loan = (struct loan){.from = hold(scene)};
    if (fill_loan(loan))
        return true;
    loan_return(loan);
    return false;
}

bool loan_renew(struct loan *loan) {
    struct geometry before = loan->stage.geometry;
    loan->stage.geometry = (struct geometry){0};
    take_back(loan);
    bool ok = fill_loan(loan);
    if (ok)
        geometry_follow(&loan->stage.geometry, &before);
    geometry_free(&before);
    return ok;
}

/* Nodes and surfaces differ in number where lights or lamps do. */
bool loan_is_followed(const struct loan *loan) {
    const struct scene *then = &loan->stage.scene, *now = &loan->from->stage.scene;
    return loan->edition >= loan->from->reshaped && then->node_count == now->node_count &&
           then->surface_count == now->surface_count;
}

bool loan_is_current(const struct loan *loan) {
    return loan->edition == loan->from->edition;
}

void loan_return(struct loan *loan) {
    if (!loan->from)
        return;
    take_back(loan);
    release(loan->from);
    *loan = (struct loan){0};
}

/* --- cameras ---------------------------------------------------------------------------------- */

bool check_camera(const struct manylight_camera *camera) {
    return desc_check_all("eye", camera->eye, 3, -INFINITY, INFINITY) &&
           desc_check_all("forward", camera->forward, 3, -INFINITY, INFINITY) &&
           desc_check_all("up", camera->up, 3, -INFINITY, INFINITY) &&
           desc_check_all("right", camera->right, 3, -INFINITY, INFINITY) &&
           desc_check("fov_y (radians)", (double)camera->fov_y, 0,
                      camera->lens >= MANYLIGHT_LENS_EQUIDISTANT ? 6.2832 : 3.14159) &&
           desc_check("y_extent", (double)camera->y_extent, 0, INFINITY) &&
           desc_check("near_plane", (double)camera->near_plane, 0, INFINITY) &&
           desc_check("far_plane", (double)camera->far_plane, 0, INFINITY) &&
           desc_check_all("shift", camera->shift, 2, -INFINITY, INFINITY) &&
           desc_check("skew", (double)camera->skew, -INFINITY, INFINITY) &&
           desc_check_all("distortion", camera->distortion, 8, -INFINITY, INFINITY);
}

static bool refuse_camera(void) {
    error_prefix("camera");
    return door_blame(MANYLIGHT_BAD_ARGUMENT);
}

static bool place_camera(struct camera *to, const struct manylight_camera *given) {
    struct manylight_camera camera;
    if (!desc_take(&camera, sizeof camera, given, "manylight_camera"))
        return false;
    if (!check_camera(&camera))
        return refuse_camera();
    if (desc_is_zero(camera.forward, 3))
        camera.forward[2] = -1;
    if (desc_is_zero(camera.up, 3))
        camera.up[1] = 1;
    bool orthographic = camera.fov_y == 0 && camera.y_extent > 0;
    *to = (struct camera){.orthographic = orthographic,
                          .fov_y = orthographic        ? 0
                                   : camera.fov_y == 0 ? .8F
                                                       : camera.fov_y,
                          .y_extent = camera.y_extent,
                          .near = camera.near_plane,
                          .far = camera.far_plane,
                          .shift = {camera.shift[0], camera.shift[1]},
                          .lens = (enum camera_lens)camera.lens,
                          .skew = camera.skew};
    memcpy(to->distortion, camera.distortion, sizeof to->distortion);
    camera_look(to, camera.eye, camera.forward, camera.up);
    if (!desc_is_zero(camera.right, 3)) {
        take_vector(to->right, camera.right);
        take_vector(to->up, camera.up);
        take_vector(to->forward, camera.forward);
    }
    return camera_check(to) || refuse_camera();
}

bool loan_pose(struct loan *loan, const struct manylight_view *view) {
    struct stage *stage = &loan->stage;
    stage->camera_text = view->camera;
    stage->light_text = view->light ? view->light : loan->from->light;
    bool ok = (view->placed || (!view->placed_next && !view->placed_previous) ||
               error_set("placed_next, placed_previous: for views with placed")) &&
              desc_check("time", view->time, 0, 1e6) && desc_check("step", view->step, 0, 1e6) &&
              stage_pose(stage, view->time);
    stage->camera_text = NULL;
    stage->light_text = loan->from->light;
    if (!ok)
        return door_blame(MANYLIGHT_BAD_ARGUMENT);
    return !view->placed || place_camera(&stage->camera, view->placed);
}

bool loan_place_others(const struct manylight_view *view, struct camera others[2]) {
    return place_camera(&others[0], view->placed_next ? view->placed_next : view->placed) &&
           place_camera(&others[1], view->placed_previous ? view->placed_previous : view->placed);
}

bool loan_find_motion(struct loan *loan, const char *camera, const struct camera *placed,
                      double time, double step, struct surface_motion *motion) {
    struct stage *stage = &loan->stage;
    stage->camera_text = placed ? NULL : camera;
    bool ok = stage_find_motion(stage, time, step > 0 ? step : 1 / 25., motion);
    stage->camera_text = NULL;
    if (ok && placed)
        memcpy(motion->cameras, placed, sizeof motion->cameras);
    return ok;
}

static bool place_named(const struct loan *loan, const char *text, struct camera *camera,
                        int size[2]) {
    int n = 0;
    if (!camera_from_text(camera, &loan->stage.scene, text, 0, &n))
        return door_blame(MANYLIGHT_BAD_ARGUMENT);
    camera_default_size(&loan->stage.scene, n, size);
    return true;
}

bool loan_size(const struct loan *loan, const char *camera, int width, int height, int size[2]) {
    static const struct option option = {"size", 0, OPTION_SIZE, 0, 0, 1, 16384, .help = ""};
    struct camera placed;
    char text[32];
    if (!place_named(loan, camera, &placed, size))
        return false;
    snprintf(text, sizeof text, "%dx%d", width, height);
    return (width == 0 && height == 0) || option_parse(&option, size, text) ||
           door_blame(MANYLIGHT_BAD_ARGUMENT);
}

static bool give_camera(const struct camera *camera, struct manylight_camera *out) {
    struct manylight_camera given = {.fov_y = camera->orthographic ? 0 : camera->fov_y,
                                     .y_extent = camera->orthographic ? camera->y_extent : 0,
                                     .near_plane = camera->near,
                                     .far_plane = camera->far,
                                     .shift = {camera->shift[0], camera->shift[1]},
                                     .lens = (enum manylight_lens)camera->lens,
                                     .skew = camera->skew};
    memcpy(given.distortion, camera->distortion, sizeof given.distortion);
    take_vector(given.eye, camera->eye);
    take_vector(given.forward, camera->forward);
    take_vector(given.up, camera->up);
    take_vector(given.right, camera->right);
    return desc_give(out, &given, sizeof given, "manylight_camera");
}

enum manylight_status manylight_scene_camera(const struct manylight_scene *scene, const char *text,
                                             double time, struct manylight_camera *camera) {
    struct door door;
    struct camera placed;
    door_enter(&door);
    bool ok = scene_use(scene) &&
              camera_from_text(&placed, &scene->stage.scene, text, time, NULL) &&
              give_camera(&placed, camera);
    scene_leave(scene);
    return door_leave(&door, ok, MANYLIGHT_BAD_ARGUMENT);
}

const char *manylight_scene_name(const struct manylight_scene *scene, enum manylight_part part,
                                 uint32_t id) {
    struct door door;
    door_enter(&door);
    const char *name = scene_use(scene)
                           ? surface_layer_id_name(&scene->stage.scene, (int)part, (int)id - 1)
                           : NULL;
    scene_leave(scene);
    door_leave(&door, true, MANYLIGHT_OK);
    return name;
}

uint32_t manylight_matte_id(const char *name) {
    return name ? cryptomatte_id(name) : 0;
}

static bool set_distortion(struct camera *camera, const struct manylight_pinhole *pinhole) {
    bool ok = desc_check("skew", pinhole->skew, -INFINITY, INFINITY);
    camera->skew = (float)(pinhole->skew / pinhole->fx);
    for (int i = 0; ok && i < 8; i++) {
        ok = desc_check("distortion", pinhole->distortion[i], -INFINITY, INFINITY);
        camera->distortion[i] = (float)pinhole->distortion[i];
    }
    return ok;
}

static bool make_pinhole(const struct manylight_pinhole *given, struct manylight_camera *out) {
    static const double identity[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    struct manylight_pinhole pinhole;
    struct camera camera = {.near = 0};
    if (!desc_take(&pinhole, sizeof pinhole, given, "manylight_pinhole"))
        return false;
    if ((unsigned)pinhole.axes > MANYLIGHT_OPENCV)
        return error_set("axes: %d is none of enum manylight_axes", (int)pinhole.axes);
    bool is_zero = true;
    for (int i = 0; i < 16; i++)
        is_zero &= pinhole.pose[i] == 0;
    const double intrinsics[4] = {pinhole.fx, pinhole.fy, pinhole.cx, pinhole.cy};
    const int size[2] = {pinhole.width, pinhole.height};
    return camera_set_pose(&camera, is_zero ? identity : pinhole.pose,
                           pinhole.axes == MANYLIGHT_OPENCV) &&
           camera_set_intrinsics(&camera, intrinsics, size) && set_distortion(&camera, &pinhole) &&
           camera_check(&camera) && give_camera(&camera, out);
}

enum manylight_status manylight_camera_pinhole(const struct manylight_pinhole *pinhole,
                                               struct manylight_camera *camera) {
    struct door door;
    door_enter(&door);
    return door_leave(&door, make_pinhole(pinhole, camera), MANYLIGHT_BAD_ARGUMENT);
}

static bool write_rays(const struct manylight_camera *given, int width, int height, float *rays) {
    struct camera camera;
    if (!place_camera(&camera, given) || !lens_check_size(&camera, width, height))
        return false;
    if (width <= 0 || height <= 0 || width > 16384 || height > 16384)
        return error_set("%dx%d is no size of a picture", width, height);
    for (int i = 0; i < width * height; i++) {
        float origin[3], x = (float)(i % width) + .5F, y = (float)(i / width) + .5F;
        camera_ray(&camera, x / (float)width, y / (float)height, (float)width / (float)height,
                   origin, rays + 3 * (size_t)i);
    }
    return true;
}

enum manylight_status manylight_camera_rays(const struct manylight_camera *camera, int width,
                                            int height, float *directions) {
    struct door door;
    door_enter(&door);
    return door_leave(&door, write_rays(camera, width, height, directions), MANYLIGHT_BAD_ARGUMENT);
}

/* --- facts ------------------------------------------------------------------------------------ */

enum manylight_status manylight_scene_info(const struct manylight_scene *scene,
                                           struct manylight_scene_info *info) {
    struct door door;
    door_enter(&door);
    bool ok = scene_use(scene) &&
              desc_give(info, &scene->info, sizeof scene->info, "manylight_scene_info");
    scene_leave(scene);
    return door_leave(&door, ok, MANYLIGHT_BAD_ARGUMENT);
}
