#include "apps/export/pack.h"

#include "apps/export/lights.h"
#include "apps/export/textures.h"
#include "base/error.h"
#include "base/file/output_file.h"
#include "base/file/piped_file.h"
#include "base/json.h"
#include "base/memory.h"
#include "base/sha256.h"
#include "scene/lights/environment.h"

#include <cglm/cglm.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* --- values ----------------------------------------------------------------------------------- */

static void print_vector(FILE *out, const char *name, const float vector[3]) {
    fprintf(out, "\"%s\": [", name);
    for (int c = 0; c < 3; c++) {
        fprintf(out, c ? ", " : "");
        json_print_number(out, (double)vector[c] + 0.0); /* no "-0" */
    }
    fprintf(out, "]");
}

/* In the file's coordinates, which the program may have moved. */
static void print_place(FILE *out, const struct scene *scene, const float place[3]) {
    fprintf(out, "\"position\": [");
    for (int c = 0; c < 3; c++)
        fprintf(out, "%s%.12g", c ? ", " : "", scene->origin[c] + (double)place[c] + 0.0);
    fprintf(out, "]");
}

/* null where it is none. */
static void print_number(FILE *out, const char *name, double number, bool is_there) {
    fprintf(out, "\"%s\": ", name);
    json_print_number(out, is_there ? number : NAN);
}

/* --- camera, lights --------------------------------------------------------------------------- */

static void print_camera(FILE *out, const struct stage *stage) {
    const struct camera *camera = &stage->camera;
    fprintf(out, " \"camera\": {\n  \"type\": \"%s\",\n  ",
            camera->orthographic ? "orthographic" : "perspective");
    print_place(out, &stage->scene, camera->eye);
    fprintf(out, ",\n  ");
    print_vector(out, "right", camera->right);
    fprintf(out, ",\n  ");
    print_vector(out, "up", camera->up);
    fprintf(out, ",\n  ");
    print_vector(out, "forward", camera->forward);
    fprintf(out, ",\n  ");
    print_number(out, "fov_y_degrees", (double)glm_deg(camera->fov_y), !camera->orthographic);
    fprintf(out, ",\n  ");
    print_number(out, "half_height", (double)camera->y_extent, camera->orthographic);
    fprintf(out, ",\n  ");
    print_number(out, "near", (double)camera->near, camera->near > 0);
    fprintf(out, ", ");
    print_number(out, "far", (double)camera->far, camera->far > 0);
    fprintf(out, "\n },\n");
}

static const char *const shape_names[] = {"point", "rectangle", "disk", "sphere", "cap"};

static void print_size(FILE *out, const struct emitter *emitter) {
    bool sized = emitter->size[0] > 0, angular = emitter_shape(emitter) == EMITTER_IS_CAP;
    fprintf(out, "   \"shape\": \"%s\", ", shape_names[emitter_shape(emitter)]);
    print_number(out, "width", (double)emitter->size[0], sized && !angular);
    fprintf(out, ", ");
    print_number(out, "height", (double)emitter->size[1], sized && emitter->size[1] > 0);
    fprintf(out, ", ");
    print_number(out, "angle_degrees", (double)glm_deg(emitter->size[0]), angular);
}

/* Of area lights and spheres the radiance, too, of others null. */
static void print_strength(FILE *out, const struct emitter *emitter) {
    float radiance[3];
    bool is_sun = emitter->type == EMITTER_DIRECTIONAL;
    print_vector(out, is_sun ? "irradiance" : "intensity", emitter->intensity);
    fprintf(out, ",\n   \"%s\": null, ", is_sun ? "intensity" : "irradiance");
    if (export_is_shape(emitter)) {
        export_radiance(emitter, radiance);
        print_vector(out, "radiance", radiance);
    } else
        fprintf(out, "\"radiance\": null");
}

static void print_light(FILE *out, const struct stage *stage, const struct emitter *emitter) {
    bool is_spot = emitter->type == EMITTER_SPOT;
    fprintf(out, "{\n   \"type\": \"%s\",\n   ", emitter_type_names[emitter->type]);
    print_place(out, &stage->scene, emitter->position);
    fprintf(out, ",\n   ");
    print_vector(out, "direction", emitter->direction);
    fprintf(out, ",\n   ");
    print_vector(out, "right", emitter->right);
    fprintf(out, ",\n   ");
    print_vector(out, "up", emitter->up);
    fprintf(out, ",\n   ");
    print_strength(out, emitter);
    fprintf(out, ",\n   ");
    print_number(out, "cos_inner", (double)emitter->cos_inner, is_spot);
    fprintf(out, ", ");
    print_number(out, "cos_outer", (double)emitter->cos_outer, is_spot);
    fprintf(out, ", ");
    print_number(out, "range", (double)emitter->range, emitter->range > 0);
    fprintf(out, ",\n");
    print_size(out, emitter);
    fprintf(out, "\n  }");
}

static void print_lights(FILE *out, const struct stage *stage) {
    const char *before = "";
    fprintf(out, " \"lights\": [");
    for (int i = 0; i < stage->emitters.count; i++)
        if (export_is_light(&stage->emitters.items[i])) {
            fprintf(out, "%s", before);
            print_light(out, stage, &stage->emitters.items[i]);
            before = ", ";
        }
    fprintf(out, "],\n");
}

/* --- files ------------------------------------------------------------------------------------ */

static bool hash_file(const struct export_target *target, const char *name,
                      char sum[SHA256_DIGITS + 1]) {
    char *path = export_path(target, name);
    bool ok = sha256_of_file(path, sum);
    free(path);
    return ok;
}

static bool copy_scene(const struct export_target *target, char sum[SHA256_DIGITS + 1]) {
    const char *from = target->stage->scene.path;
    struct file_bytes bytes;
    if (!piped_file_read(&bytes, from))
        return false;
    char *path = export_path(target, "scene.glb");
    bool ok =
        (bytes.size > 4 && memcmp(bytes.data, "glTF", 4) == 0) ||
        error_set("%s: a pack holds a GLB, which it is not; --format mitsuba and pbrt take it",
                  from);
    ok = ok && output_file_write(path, bytes.data, bytes.size);
    if (ok)
        sha256(bytes.data, bytes.size, sum);
    free(bytes.data);
    free(path);
    return ok;
}

static bool print_environment(const struct export_target *target, FILE *out) {
    const struct environment *sky = target->stage->emitters.sky;
    char sum[SHA256_DIGITS + 1];
    if (!sky) {
        fprintf(out, " \"environment\": null,\n");
        return true;
    }
    if (!export_panorama(target, "environment.exr") || !hash_file(target, "environment.exr", sum))
        return false;
    fprintf(out,
            " \"environment\": {\"file\": \"environment.exr\", \"sha256\": \"%s\",\n"
            "  \"width\": %d, \"height\": %d, \"turn_degrees\": %.9g, \"strength\": %.9g},\n",
            sum, sky->width, sky->height, (double)sky->turn, (double)sky->strength);
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
                     "they deform; --format mitsuba and pbrt take them");
}

static void print_head(FILE *out, const struct export_target *target, const char *sum) {
    const struct stage *stage = target->stage;
    fprintf(out, "{\"format\": \"manylight scene pack\", \"version\": 1,\n \"name\": ");
    json_print_text(out, stage->name);
    fprintf(out,
            ",\n \"scene\": {\"file\": \"scene.glb\", \"sha256\": \"%s\", \"triangles\": %u, "
            "\"time_s\": %.9g},\n",
            sum, geometry_triangle_count(&stage->geometry), stage->geometry.pose.time);
    fprintf(out, " \"units\": {\"length\": \"m\", \"up\": \"+Y\", \"handedness\": \"right\",\n"
                 "  \"colour\": \"linear, primaries and white of sRGB\", \"intensity\": \"W/sr\",\n"
                 "  \"irradiance\": \"W/m2\", \"radiance\": \"W/(sr m2)\"},\n");
    fprintf(out, " \"picture\": {\"file\": ");
    char *file = mem_printf("%s.%dx%d.exr", stage->name, target->width, target->height);
    json_print_text(out, file);
    free(file);
    fprintf(
        out,
        ", \"width\": %d, \"height\": %d,\n  \"filter\": \"box of one pixel\", \"exposure\": 1, "
        "\"bounces\": %d, \"materials\": \"%s\"},\n",
        target->width, target->height, target->bounces, materials_names[target->materials]);
}

bool export_pack(struct export_target *target) {
    char sum[SHA256_DIGITS + 1];
    struct output_text json;
    bool shines;
    if (!find_shining(target, &shines) || !copy_scene(target, sum))
        return false;
    output_text_init(&json);
    print_head(json.stream, target, sum);
    print_camera(json.stream, target->stage);
    print_lights(json.stream, target->stage);
    bool ok = print_environment(target, json.stream);
    fprintf(json.stream, " \"emissive_surfaces\": %s\n}\n", shines ? "true" : "false");
    char *path = export_path(target, "scene.json");
    ok = output_text_end(&json, path) && ok;
    free(path);
    return ok;
}
