#define _POSIX_C_SOURCE 200809L
#include "apps/scene_summary.h"

#include "apps/facts.h"
#include "scene/camera.h"
#include "scene/clips.h"
#include "scene/lights/emitter.h"
#include "scene/lights/environment.h"
#include "scene/lights/slide.h"
#include "scene/material.h"
#include "scene/medium.h"
#include "scene/node.h"
#include "scene/open.h"

#include <cglm/util.h>
#include <math.h>
#include <sys/stat.h>

static double degrees(float radians) {
    return (double)glm_deg(radians);
}

/* Of the file, each mesh counted once. */
static void print_meshes(struct json *json, const struct scene *scene) {
    int primitives = 0;
    long vertices = 0, triangles = 0;
    for (int m = 0; m < scene->mesh_count; m++) {
        const struct mesh *mesh = &scene->meshes[m];
        primitives += mesh->primitive_count;
        for (int p = 0; p < mesh->primitive_count; p++) {
            vertices += mesh->primitives[p].vertex_count;
            triangles += mesh->primitives[p].index_count / 3;
        }
    }
    int hidden = 0;
    for (int i = 0; i < scene->node_count; i++)
        hidden += scene->nodes[i].hidden;
    fact_count(json, "nodes", "nodes      %lld", scene->node_count);
    if (hidden)
        fact_count(json, "hidden_nodes", " (hidden %lld)", hidden);
    fact_count(json, "meshes", "\nmeshes     %lld", scene->mesh_count);
    fact_count(json, "primitives", " (primitives %lld)", primitives);
    fact_count(json, "vertices", ", %lld vertices", vertices);
    fact_count(json, "triangles", ", %lld triangles\n", triangles);
}

/* Lines and points, which nothing draws. */
static void print_left_out(struct json *json, const struct scene *scene) {
    const char *rest = " primitives %lld, not drawn\n";
    if (scene->point_primitives) {
        fact_words(json, "points    ");
        fact_count(json, "point_primitives", rest, scene->point_primitives);
    }
    if (scene->line_primitives) {
        fact_words(json, "lines     ");
        fact_count(json, "line_primitives", rest, scene->line_primitives);
    }
}

/* As drawn: a mesh counts once for each node that shows it. */
static void print_geometry(struct json *json, const struct geometry *geometry) {
    json_open(json, "drawn", "{");
    fact_count(json, "vertices", "drawn      %lld vertices", geometry->vertex_count);
    fact_count(json, "triangles", ", %lld triangles", geometry_triangle_count(geometry));
    fact_count(json, "unmasked_triangles", " (%lld without alpha mask)",
               geometry->opaque_index_count / 3);
    fact_count(json, "batches", ", batches %lld\n", geometry->batch_count);
    if (geometry->vertex_count > 0) {
        fact_vector(json, "bounds_min", "bounds     ", geometry->bounds_min, "");
        fact_vector(json, "bounds_max", " to ", geometry->bounds_max, " m");
        fact_number(json, "radius", ", sphere of radius %.4g m\n", (double)geometry->radius);
    }
    json_close(json, "}");
}

/* As far as caustics and what they show depend on it. */
static void print_glass(struct json *json, const struct material *material) {
    const float *absorption = material->absorption;
    if (material->transmission <= 0)
        return;
    fact_number(json, "transmission", ", transmission %.4g", (double)material->transmission);
    fact_number(json, "index_of_refraction", ", index of refraction %.4g",
                (double)material->index_of_refraction);
    if (material->thin_walled)
        fact_flag(json, "thin", true, ", thin");
    else if (absorption[0] > 0 || absorption[1] > 0 || absorption[2] > 0)
        fact_vector(json, "absorption", ", absorbs ", absorption, " 1/m");
}

/* A star marks what a texture multiplies. */
static void print_material(struct json *json, const struct material *material, int n) {
    fact_count(json, "number", "  %lld", n);
    fact_text(json, "name", "  %-20s ", material->name);
    fact_vector(json, "base_color", "base colour ", material->base_color, "");
    fact_flag(json, "base_color_texture", material->base_color_texture >= 0, "*");
    const char *star = material->metal_roughness_texture >= 0 ? "*" : "";
    fact_number(json, "metalness", ", metalness %.4g", (double)material->metalness);
    fact_words(json, star);
    fact_number(json, "roughness", ", roughness %.4g", (double)material->roughness);
    fact_words(json, star);
    json_flag(json, "metal_roughness_texture", *star);
    if (material->emission[0] > 0 || material->emission[1] > 0 || material->emission[2] > 0) {
        fact_vector(json, "emission", ", emission ", material->emission, "");
        fact_flag(json, "emission_texture", material->emission_texture >= 0, "*");
        fact_words(json, " W/(sr m2)");
    }
    fact_flag(json, "normal_map", material->normal_texture >= 0, ", normal map");
    print_glass(json, material);
    fact_flag(json, "unlit", material->unlit, ", unlit");
    fact_flag(json, "alpha_mask", material->alpha_mask, ", alpha mask");
    fact_flag(json, "double_sided", material->double_sided, ", double-sided");
}

static void open_list(struct json *json, const char *noun, int count) {
    json_open(json, noun, "[");
    if (!json->out)
        printf("%-10s %d\n", noun, count);
}

static void open_row(struct json *json) {
    json_open(json, NULL, "{");
}

static void close_row(struct json *json) {
    json_close(json, "}");
    fact_words(json, "\n");
}

static void print_materials(struct json *json, const struct scene *scene) {
    open_list(json, "materials", scene->material_count);
    for (int i = 0; i < scene->material_count; i++) {
        open_row(json);
        print_material(json, &scene->materials[i], i);
        close_row(json);
    }
    json_close(json, "]");
    double texels = 0;
    for (int i = 0; i < scene->texture_count; i++)
        texels += (double)scene->textures[i].bitmap.width * scene->textures[i].bitmap.height;
    fact_count(json, "textures", "textures   %lld", scene->texture_count);
    fact_number(json, "megatexels", " (%.2f megatexels)\n", texels / 1e6);
}

static void print_size(struct json *json, const struct emitter *light) {
    double across = (double)light->size[0];
    switch (emitter_shape(light)) {
    case EMITTER_IS_POINT:
        break;
    case EMITTER_IS_RECTANGLE:
        fact_number(json, "width", ", %.4g", across);
        fact_number(json, "height", " x %.4g m", (double)light->size[1]);
        break;
    case EMITTER_IS_DISK:
    case EMITTER_IS_SPHERE:
        fact_number(json, "diameter", ", %.4g m across", across);
        break;
    case EMITTER_IS_CAP:
        fact_number(json, "angle", ", %.4g degrees across", degrees(light->size[0]));
        break;
    }
}

static void print_name(struct json *json, int n, const char *name) {
    fact_count(json, "number", "  %lld", n);
    fact_text(json, "name", "  %-20s ", name);
}

static void print_light(struct json *json, const struct scene *scene, int node,
                        const struct emitter *placed) {
    const struct scene_light *source = &scene->lights[scene->nodes[node].light];
    const struct emitter light = *placed;
    bool is_sun = light.type == EMITTER_DIRECTIONAL;
    print_name(json, light.number, node_shown_name(scene, NODE_LIGHT, node));
    fact_text(json, "type", "%s ", emitter_type_names[light.type]);
    fact_vector(json, is_sun ? "irradiance" : "intensity", "", light.intensity,
                is_sun ? " W/m2" : " W/sr");
    if (!is_sun)
        fact_vector(json, "position", " at ", light.position, "");
    if (light.type != EMITTER_POINT)
        fact_vector(json, "direction", " towards ", light.direction, "");
    if (light.type == EMITTER_SPOT) {
        fact_number(json, "inner_angle", ", cone %.4g", degrees(acosf(light.cos_inner)));
        fact_number(json, "outer_angle", " to %.4g degrees", degrees(acosf(light.cos_outer)));
    }
    print_size(json, &light);
    if (light.slide && light.slide->is_profile)
        fact_flag(json, "profile", true, ", by a profile");
    else if (light.slide) {
        fact_count(json, "slide_width", ", slide of %lld", light.slide->width);
        fact_count(json, "slide_height", " x %lld texels", light.slide->height);
    }
    if (light.stands_in)
        fact_flag(json, "stands_in", true, ", for a part of what emits");
    if (isfinite(source->range))
        fact_number(json, "range", ", range %.4g m", (double)source->range);
}

static void print_camera(struct json *json, const struct scene *scene, int n) {
    struct camera camera;
    camera_place(&camera, scene, n, 0);
    print_name(json, n, node_name_carrying(scene, NODE_CAMERA, n));
    fact_text(json, "type", "%s, ", camera.orthographic ? "orthographic" : "perspective");
    if (camera.orthographic)
        fact_number(json, "height", "%.4g m high", 2 * (double)camera.y_extent);
    else
        fact_number(json, "fov_y", "%.4g degrees high", degrees(camera.fov_y));
    const struct scene_camera *source =
        &scene->cameras[scene->nodes[node_carrying(scene, NODE_CAMERA, n)].camera];
    if (source->aspect > 0)
        fact_number(json, "aspect_ratio", ", aspect ratio %.4g", (double)source->aspect);
    fact_vector(json, "position", ", at ", camera.eye, "");
    fact_vector(json, "direction", " towards ", camera.forward, "");
    bool ends = camera.far > 0;
    if (ends || camera.near > 0)
        fact_number(json, "near", ends ? ", sees %.4g" : ", sees from %.4g m on",
                    (double)camera.near);
    if (ends)
        fact_number(json, "far", " to %.4g m", (double)camera.far);
}

/* Rows of a list: as text the first hundred. */
static int rows_of(const struct json *json, int count) {
    enum { MOST_ROWS = 100 };
    return !json->out && count > MOST_ROWS ? MOST_ROWS : count;
}

static void close_list(struct json *json, int count) {
    json_close(json, "]");
    if (count > rows_of(json, count))
        printf("  ... and %d more\n", count - rows_of(json, count));
}

static void print_lights(struct json *json, const struct scene *scene) {
    struct emitters all = emitters_place(scene, 0);
    open_list(json, "lights", all.count);
    for (int node = 0, n = 0; n < rows_of(json, all.count); node++) {
        if (scene->nodes[node].light < 0)
            continue;
        open_row(json);
        print_light(json, scene, node, &all.items[n++]);
        close_row(json);
    }
    close_list(json, all.count);
    emitters_free(&all);
}

static void print_each(struct json *json, const char *noun, const struct scene *scene, int count,
                       void (*print)(struct json *json, const struct scene *scene, int n)) {
    open_list(json, noun, count);
    for (int n = 0; n < rows_of(json, count); n++) {
        open_row(json);
        print(json, scene, n);
        close_row(json);
    }
    close_list(json, count);
}

static void print_sky(struct json *json, const struct environment *sky) {
    double brightest = 0;
    for (size_t i = 0; i < (size_t)sky->width * (size_t)sky->height; i++)
        for (int c = 0; c < 3; c++)
            brightest = fmax(brightest, (double)sky->strength * (double)sky->texels[i][c]);
    json_open(json, "environment", "{");
    fact_text(json, "file", "sky        %s", sky->path);
    fact_count(json, "width", ", %lld", sky->width);
    fact_count(json, "height", " x %lld", sky->height);
    fact_number(json, "radiance_max", ", up to %.4g W/(sr m2)", brightest);
    fact_number(json, "turn", ", turned by %.4g degrees", (double)sky->turn);
    close_row(json);
}

static void print_medium(struct json *json, const struct medium *medium) {
    json_open(json, "medium", "{");
    fact_vector(json, "scattering", "medium     scatters ", medium->scattering, "");
    fact_vector(json, "absorption", ", absorbs ", medium->absorption, " 1/m");
    fact_number(json, "g", ", g %.4g", (double)medium->g);
    close_row(json);
}

/* Counted as --light and --camera count them: by node. */
static void print_placed(struct json *json, const struct scene *scene) {
    print_lights(json, scene);
    if (scene->environment)
        print_sky(json, scene->environment);
    if (medium_exists(&scene->medium))
        print_medium(json, &scene->medium);
    print_each(json, "cameras", scene, camera_node_count(scene), print_camera);
}

static void print_clip(struct json *json, const struct scene *scene, int n) {
    const struct clip *clip = &scene->clips[n];
    fact_count(json, "number", "  %lld", n);
    fact_text(json, "name", "  %-20s ", clip->name);
    fact_number(json, "duration", "%.4g s", (double)clip->duration);
    fact_count(json, "channels", ", channels %lld", clip->channel_count);
    if (!clip_plays(scene, n))
        fact_flag(json, "by_choice", true, ", only by --clip");
}

static void print_clips(struct json *json, const struct scene *scene) {
    open_list(json, "clips", scene->clip_count);
    for (int i = 0; i < scene->clip_count; i++) {
        open_row(json);
        print_clip(json, scene, i);
        close_row(json);
    }
    json_close(json, "]");
    if (scene->skin_count)
        fact_count(json, "skins", "skins      %lld\n", scene->skin_count);
    if (scene->metaballs_count)
        fact_count(json, "metaballs", "metaballs  %lld\n", scene->metaballs_count);
}

/* Of the file, where there is a choice. */
static void print_choice(struct json *json, const char *noun, const struct choice_list *list,
                         int least) {
    if (list->count < least)
        return;
    open_list(json, noun, list->count);
    for (int i = 0; i < list->count; i++) {
        open_row(json);
        fact_count(json, "number", "  %lld", i);
        fact_text(json, "name", "  %-20s", list->names[i]);
        fact_flag(json, "shown", i == list->shown, " shown");
        close_row(json);
    }
    json_close(json, "]");
}

static void print_origin(struct json *json, const double origin[3]) {
    if (origin[0] == 0 && origin[1] == 0 && origin[2] == 0)
        return;
    json_open(json, "origin", "[");
    fact_number(json, NULL, "origin     (%.9g", origin[0]);
    fact_number(json, NULL, ", %.9g", origin[1]);
    fact_number(json, NULL, ", %.9g) m: positions are relative to it\n", origin[2]);
    json_close(json, "]");
}

static double file_bytes(const struct scene *scene) {
    struct stat info;
    double bytes = stat(scene->path, &info) == 0 ? (double)info.st_size : 0;
    for (int i = 0; i < scene->file_count; i++)
        bytes += stat(scene->files[i], &info) == 0 ? (double)info.st_size : 0;
    return bytes;
}

/* Slides lie in layers as wide and high as the greatest. */
static double texel_count(const struct scene *scene) {
    double texels = 0, width = 0, height = 0;
    for (int i = 0; i < scene->texture_count; i++)
        texels += (double)scene->textures[i].bitmap.width * scene->textures[i].bitmap.height;
    for (int i = 0; i < scene->slide_count; i++) {
        width = fmax(width, scene->slides[i].width);
        height = fmax(height, scene->slides[i].height);
    }
    const struct environment *sky = scene->environment;
    return texels + 2 * width * height * scene->slide_count +
           (sky ? 2. * sky->width * sky->height : 0);
}

/* Triangles that emit, which a tree of lights holds. */
static double emitting_triangles(const struct scene *scene, const struct geometry *geometry) {
    double count = 0;
    for (int i = 0; i < geometry->batch_count; i++) {
        const struct geometry_batch *batch = &geometry->batches[i];
        if (glm_vec3_max((float *)scene->materials[batch->material].emission) > 0)
            count += batch->index_count / 3;
    }
    return count;
}

/* Bounds the peak memory of a frame by software OpenGL, which keeps textures and buffers there. A
 * thing's bytes bound what was measured (docs/notes/many-lights.md): nodes and lights are objects
 * of JSON while they are read, and triangles lie in a BVH while casters are made. */
static void print_memory(struct json *json, const struct scene *scene,
                         const struct geometry *geometry) {
    const double mib = 1 << 20, program = 256, megapixel = 240;
    const double of_item = 6e3, of_vertex = 120, of_triangle = 700, of_texel = 20, of_lamp = 1200;
    double bytes = 3 * file_bytes(scene) + of_item * (scene->node_count + scene->light_count) / 2 +
                   of_vertex * geometry->vertex_count +
                   of_triangle * geometry_triangle_count(geometry) + of_texel * texel_count(scene) +
                   of_lamp * emitting_triangles(scene, geometry);
    json_open(json, "memory", "{");
    fact_number(json, "frame", "memory     at most %.0f MiB for a frame",
                ceil(program + bytes / mib));
    fact_number(json, "megapixel", ", and %.0f MiB for each million pixels\n", megapixel);
    json_close(json, "}");
}

bool scene_summary_print(struct json *json, const char *path, const struct scene_choice *choice) {
    struct scene scene;
    struct geometry geometry;
    const struct scene_open_desc desc = {.may_be_empty = true, .choice = *choice};
    bool ok = scene_open(&scene, &geometry, path, &desc);
    if (ok) {
        fact_text(json, "scene", "scene      %s\n", path);
        print_choice(json, "scenes", &scene.scenes, 2);
        print_choice(json, "variants", &scene.variants, 1);
        print_meshes(json, &scene);
        print_left_out(json, &scene);
        print_geometry(json, &geometry);
        print_origin(json, scene.origin);
        print_materials(json, &scene);
        print_placed(json, &scene);
        print_clips(json, &scene);
        print_memory(json, &scene, &geometry);
    }
    geometry_free(&geometry);
    scene_free(&scene);
    return ok;
}
