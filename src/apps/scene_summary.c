#include "apps/scene_summary.h"

#include "scene/camera.h"
#include "scene/emitter.h"
#include "scene/node.h"
#include "scene/open.h"

#include <cglm/util.h>
#include <math.h>

static double degrees(float radians) {
    return (double)glm_deg(radians);
}

static void print_vector(FILE *out, const char *before, const float v[3]) {
    fprintf(out, "%s(%.4g, %.4g, %.4g)", before, v[0] + 0.0, v[1] + 0.0, v[2] + 0.0); /* no "-0" */
}

/* Of the file, each mesh counted once. */
static void print_meshes(FILE *out, const struct scene *scene) {
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
    fprintf(out, "nodes      %d\n", scene->node_count);
    fprintf(out, "meshes     %d (primitives %d), %ld vertices, %ld triangles\n", scene->mesh_count,
            primitives, vertices, triangles);
}

/* As drawn: a mesh counts once for each node that shows it. */
static void print_geometry(FILE *out, const struct geometry *geometry) {
    fprintf(out, "drawn      %u vertices, %u triangles (%u without alpha mask), batches %d\n",
            geometry->vertex_count, geometry_triangle_count(geometry),
            geometry->opaque_index_count / 3, geometry->batch_count);
    print_vector(out, "bounds     ", geometry->bounds_min);
    print_vector(out, " to ", geometry->bounds_max);
    fprintf(out, " m, sphere of radius %.4g m\n", (double)geometry->radius);
}

/* A star marks what a texture multiplies. */
static void print_material(FILE *out, const struct material *material, int n) {
    static const char *const stars[] = {"", "*"};
    fprintf(out, "  %d  %-20s ", n, material->name);
    print_vector(out, "base colour ", material->base_color);
    fprintf(out, "%s, metalness %.4g%s, roughness %.4g%s", stars[material->base_color_texture >= 0],
            (double)material->metalness, stars[material->metal_roughness_texture >= 0],
            (double)material->roughness, stars[material->metal_roughness_texture >= 0]);
    if (material->emission[0] > 0 || material->emission[1] > 0 || material->emission[2] > 0) {
        print_vector(out, ", emission ", material->emission);
        fprintf(out, "%s W/(sr m2)", stars[material->emission_texture >= 0]);
    }
    fprintf(out, "%s%s\n", material->alpha_mask ? ", alpha mask" : "",
            material->double_sided ? ", double-sided" : "");
}

static void print_materials(FILE *out, const struct scene *scene) {
    fprintf(out, "materials  %d\n", scene->material_count);
    for (int i = 0; i < scene->material_count; i++)
        print_material(out, &scene->materials[i], i);
    double texels = 0;
    for (int i = 0; i < scene->texture_count; i++)
        texels += (double)scene->textures[i].bitmap.width * scene->textures[i].bitmap.height;
    fprintf(out, "textures   %d (%.2f megatexels)\n", scene->texture_count, texels / 1e6);
}

static void print_light(FILE *out, const struct scene *scene, int n) {
    static const char *const types[] = {"spot", "point", "directional"};
    struct emitter light;
    emitter_place(&light, scene, n, 0);
    const struct node *node = &scene->nodes[node_carrying(scene, NODE_LIGHT, n)];
    const struct scene_light *source = &scene->lights[node->light];
    fprintf(out, "  %d  %-20s %s", n, *node->name ? node->name : source->name, types[light.type]);
    print_vector(out, " ", light.intensity);
    fprintf(out, light.type == EMITTER_DIRECTIONAL ? " W/m2" : " W/sr");
    if (light.type != EMITTER_DIRECTIONAL)
        print_vector(out, " at ", light.position);
    if (light.type != EMITTER_POINT)
        print_vector(out, " towards ", light.direction);
    if (light.type == EMITTER_SPOT)
        fprintf(out, ", cone %.4g to %.4g degrees", degrees(acosf(light.cos_inner)),
                degrees(acosf(light.cos_outer)));
    if (isfinite(source->range))
        fprintf(out, ", not cut off at its range of %.4g m", (double)source->range);
    fputc('\n', out);
}

static void print_camera(FILE *out, const struct scene *scene, int n) {
    struct camera camera;
    camera_place(&camera, scene, n, 0);
    int node = node_carrying(scene, NODE_CAMERA, n);
    fprintf(out, "  %d  %-20s %s, ", n, scene->cameras[scene->nodes[node].camera].name,
            camera.orthographic ? "orthographic" : "perspective");
    if (camera.orthographic)
        fprintf(out, "%.4g m high", 2 * (double)camera.y_extent);
    else
        fprintf(out, "%.4g degrees high", degrees(camera.fov_y));
    print_vector(out, ", at ", camera.eye);
    print_vector(out, " towards ", camera.forward);
    fputc('\n', out);
}

/* Counted as --light and --camera count them: by node. */
static void print_placed(FILE *out, const struct scene *scene) {
    int lights = emitter_node_count(scene), cameras = camera_node_count(scene);
    fprintf(out, "lights     %d\n", lights);
    for (int n = 0; n < lights; n++)
        print_light(out, scene, n);
    fprintf(out, "cameras    %d\n", cameras);
    for (int n = 0; n < cameras; n++)
        print_camera(out, scene, n);
}

static void print_clips(FILE *out, const struct scene *scene) {
    fprintf(out, "clips      %d\n", scene->clip_count);
    for (int i = 0; i < scene->clip_count; i++)
        fprintf(out, "  %d  %-20s %.4g s, channels %d\n", i, scene->clips[i].name,
                (double)scene->clips[i].duration, scene->clips[i].channel_count);
    if (scene->skin_count)
        fprintf(out, "skins      %d\n", scene->skin_count);
    if (scene->metaballs_count)
        fprintf(out, "metaballs  %d\n", scene->metaballs_count);
}

bool scene_summary_print(FILE *out, const char *path) {
    struct scene scene;
    struct geometry geometry;
    bool ok = scene_open(&scene, &geometry, path, NULL);
    if (ok) {
        fprintf(out, "scene      %s\n", path);
        print_meshes(out, &scene);
        print_geometry(out, &geometry);
        if (scene.origin[0] != 0 || scene.origin[1] != 0 || scene.origin[2] != 0)
            fprintf(out, "origin     (%.9g, %.9g, %.9g) m: positions are relative to it\n",
                    scene.origin[0], scene.origin[1], scene.origin[2]);
        print_materials(out, &scene);
        print_placed(out, &scene);
        print_clips(out, &scene);
    }
    geometry_free(&geometry);
    scene_free(&scene);
    return ok;
}
