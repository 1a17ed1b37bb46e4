#include "lab/export/target.h"

#include "base/error.h"
#include "base/file/output_file.h"
#include "base/file/piped_file.h"
#include "base/json.h"
#include "base/memory.h"
#include "lab/export/lights.h"
#include "lab/export/textures.h"
#include "scene/lights/environment.h"

#include <cglm/cglm.h>
#include <math.h>
#include <string.h>

/* --- values ----------------------------------------------------------------------------------- */

/* In the file's coordinates, which the program may have moved. */
static void print_place(struct json *json, const struct scene *scene, const float place[3]) {
    json_open(json, "position", "[");
    for (int c = 0; c < 3; c++)
        json_number(json, NULL, scene->origin[c] + (double)place[c]);
    json_close(json, "]");
}

/* null where it is none. */
static void print_number(struct json *json, const char *name, double number, bool is_there) {
    json_number(json, name, is_there ? number : NAN);
}

/* --- camera, lights --------------------------------------------------------------------------- */

static void print_camera(struct json *json, const struct stage *stage) {
    const struct camera *camera = &stage->camera;
    json_open(json, "camera", "{");
    json_text(json, "type", camera->orthographic ? "orthographic" : "perspective");
    print_place(json, &stage->scene, camera->eye);
    json_vector(json, "right", camera->right);
    json_vector(json, "up", camera->up);
    json_vector(json, "forward", camera->forward);
    print_number(json, "fov_y_degrees", (double)glm_deg(camera->fov_y), !camera->orthographic);
    print_number(json, "half_height", (double)camera->y_extent, camera->orthographic);
    print_number(json, "near", (double)camera->near, camera->near > 0);
    print_number(json, "far", (double)camera->far, camera->far > 0);
    json_close(json, "}");
}

static const char *const shape_names[] = {"point", "rectangle", "disk", "sphere", "cap"};

static void print_size(struct json *json, const struct emitter *emitter) {
    bool sized = emitter->size[0] > 0, angular = emitter_shape(emitter) == EMITTER_IS_CAP;
    json_text(json, "shape", shape_names[emitter_shape(emitter)]);
    print_number(json, "width", (double)emitter->size[0], sized && !angular);
    print_number(json, "height", (double)emitter->size[1], sized && emitter->size[1] > 0);
    print_number(json, "angle_degrees", (double)glm_deg(emitter->size[0]), angular);
}

/* Of area lights and spheres the radiance, too, of others null. */
static void print_strength(struct json *json, const struct emitter *emitter) {
    float radiance[3];
    bool is_sun = emitter->type == EMITTER_DIRECTIONAL;
    json_vector(json, is_sun ? "irradiance" : "intensity", emitter->intensity);
    json_text(json, is_sun ? "intensity" : "irradiance", NULL);
    if (export_is_shape(emitter)) {
        export_radiance(emitter, radiance);
        json_vector(json, "radiance", radiance);
    } else
        json_text(json, "radiance", NULL);
}

static void print_light(struct json *json, const struct stage *stage,
                        const struct emitter *emitter) {
    bool is_spot = emitter->type == EMITTER_SPOT;
    json_open(json, NULL, "{");
    json_text(json, "type", emitter_type_names[emitter->type]);
    print_place(json, &stage->scene, emitter->position);
    json_vector(json, "direction", emitter->direction);
    json_vector(json, "right", emitter->right);
    json_vector(json, "up", emitter->up);
    print_strength(json, emitter);
    print_number(json, "cos_inner", (double)emitter->cos_inner, is_spot);
    print_number(json, "cos_outer", (double)emitter->cos_outer, is_spot);
    print_number(json, "range", (double)emitter->range, emitter->range > 0);
    print_size(json, emitter);
    json_close(json, "}");
}

static void print_lights(struct json *json, const struct stage *stage) {
    json_open(json, "lights", "[");
    for (int i = 0; i < stage->emitters.count; i++)
        if (export_is_light(&stage->emitters.items[i]))
            print_light(json, stage, &stage->emitters.items[i]);
    json_close(json, "]");
}

/* --- files ------------------------------------------------------------------------------------ */

static bool copy_scene(const struct export_target *target) {
    const char *from = target->stage->scene.path;
    struct file_bytes bytes;
    if (!piped_file_read(&bytes, from))
        return false;
    char *path = export_path(target, "scene.glb");
    bool ok = (bytes.size > 4 && memcmp(bytes.data, "glTF", 4) == 0) ||
              error_set("%s: a pack holds a GLB, which it is not; --format mitsuba takes it", from);
    ok = ok && output_file_write(path, bytes.data, bytes.size);
    mem_free(bytes.data, path);
    return ok;
}

static bool print_environment(const struct export_target *target, struct json *json) {
    const struct environment *sky = target->stage->emitters.sky;
    if (!sky) {
        json_text(json, "environment", NULL);
        return true;
    }
    if (!export_panorama(target, "environment.exr"))
        return false;
    json_open(json, "environment", "{");
    json_text(json, "file", "environment.exr");
    json_number(json, "width", sky->width);
    json_number(json, "height", sky->height);
    json_number(json, "turn_degrees", (double)sky->turn);
    json_number(json, "strength", (double)sky->strength);
    json_close(json, "}");
    return true;
}

/* All emissive surfaces shine, or none. */
static bool find_shining(const struct export_target *target, bool *shines) {
    int shining = 0, dark = 0;
    const struct scene *scene = &target->stage->scene;
    for (int i = 0; i < target->mesh_count; i++) {
        const struct export_mesh *mesh = &target->meshes[i];
        const float *emission = scene->materials[mesh->material].emission;
        shining += mesh->shines;
        dark += !mesh->shines && glm_vec3_max((float *)emission) > 0;
    }
    *shines = shining > 0;
    return !shining || !dark ||
           error_set("a pack's emissive surfaces shine all or none: --light leaves some dark, or "
                     "they deform; --format mitsuba takes them");
}

static void print_scene(struct json *json, const struct stage *stage) {
    json_text(json, "format", "manylight scene pack");
    json_number(json, "version", 1);
    json_text(json, "name", stage->name);
    json_open(json, "scene", "{");
    json_text(json, "file", "scene.glb");
    json_number(json, "triangles", geometry_triangle_count(&stage->geometry));
    json_number(json, "time_s", stage->geometry.pose.time);
    json_close(json, "}");
    json_value(json, "units",
               "{\"length\": \"m\", \"up\": \"+Y\", \"handedness\": \"right\",\n"
               "  \"colour\": \"linear, primaries and white of sRGB\", \"intensity\": \"W/sr\",\n"
               "  \"irradiance\": \"W/m2\", \"radiance\": \"W/(sr m2)\"}");
}

static void print_picture(struct json *json, const struct export_target *target) {
    char *file = mem_printf("%s.%dx%d.exr", target->stage->name, target->width, target->height);
    json_open(json, "picture", "{");
    json_text(json, "file", file);
    json_number(json, "width", target->width);
    json_number(json, "height", target->height);
    json_text(json, "filter", "box of one pixel");
    json_number(json, "exposure", 1);
    json_number(json, "bounces", target->bounces);
    json_text(json, "materials", materials_names[target->materials]);
    json_close(json, "}");
    free(file);
}

bool export_pack(struct export_target *target) {
    struct output_text text;
    bool shines;
    if (!find_shining(target, &shines) || !copy_scene(target))
        return false;
    output_text_init(&text);
    struct json json = {.out = text.stream, .lines = 2};
    json_open(&json, NULL, "{");
    print_scene(&json, target->stage);
    print_picture(&json, target);
    print_camera(&json, target->stage);
    print_lights(&json, target->stage);
    bool ok = print_environment(target, &json);
    json_flag(&json, "emissive_surfaces", shines);
    json_close(&json, "}");
    char *path = export_path(target, "scene.json");
    ok = output_text_end(&text, path) && ok;
    free(path);
    return ok;
}
