#include "apps/scene_summary.h"

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
#include <stdio.h>

static double degrees(float radians) {
    return (double)glm_deg(radians);
}

static void print_vector(const char *before, const float v[3]) {
    printf("%s(%.4g, %.4g, %.4g)", before, v[0] + 0.0, v[1] + 0.0, v[2] + 0.0); /* no "-0" */
}

/* Of the file, each mesh counted once. */
static void print_meshes(const struct scene *scene) {
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
    printf("nodes      %d", scene->node_count);
    printf(hidden ? " (hidden %d)\n" : "\n", hidden);
    printf("meshes     %d (primitives %d), %ld vertices, %ld triangles\n", scene->mesh_count,
           primitives, vertices, triangles);
}

/* Lines and points, which nothing draws. */
static void print_left_out(const struct scene *scene) {
    if (scene->point_primitives)
        printf("points     primitives %d, not drawn\n", scene->point_primitives);
    if (scene->line_primitives)
        printf("lines      primitives %d, not drawn\n", scene->line_primitives);
}

/* As drawn: a mesh counts once for each node that shows it. */
static void print_geometry(const struct geometry *geometry) {
    printf("drawn      %u vertices, %u triangles (%u without alpha mask), batches %d\n",
           geometry->vertex_count, geometry_triangle_count(geometry),
           geometry->opaque_index_count / 3, geometry->batch_count);
    if (geometry->vertex_count == 0)
        return;
    print_vector("bounds     ", geometry->bounds_min);
    print_vector(" to ", geometry->bounds_max);
    printf(" m, sphere of radius %.4g m\n", (double)geometry->radius);
}

/* As far as caustics and what they show depend on it. */
static void print_glass(const struct material *material) {
    const float *absorption = material->absorption;
    if (material->transmission <= 0)
        return;
    printf(", transmission %.4g, index of refraction %.4g", (double)material->transmission,
           (double)material->index_of_refraction);
    if (material->thin_walled)
        printf(", thin");
    else if (absorption[0] > 0 || absorption[1] > 0 || absorption[2] > 0) {
        print_vector(", absorbs ", absorption);
        printf(" 1/m");
    }
}

/* A star marks what a texture multiplies. */
static void print_material(const struct material *material, int n) {
    static const char *const stars[] = {"", "*"};
    printf("  %d  %-20s ", n, material->name);
    print_vector("base colour ", material->base_color);
    printf("%s, metalness %.4g%s, roughness %.4g%s", stars[material->base_color_texture >= 0],
           (double)material->metalness, stars[material->metal_roughness_texture >= 0],
           (double)material->roughness, stars[material->metal_roughness_texture >= 0]);
    if (material->emission[0] > 0 || material->emission[1] > 0 || material->emission[2] > 0) {
        print_vector(", emission ", material->emission);
        printf("%s W/(sr m2)", stars[material->emission_texture >= 0]);
    }
    if (material->normal_texture >= 0)
        printf(", normal map");
    print_glass(material);
    printf("%s%s%s\n", material->unlit ? ", unlit" : "", material->alpha_mask ? ", alpha mask" : "",
           material->double_sided ? ", double-sided" : "");
}

static void print_materials(const struct scene *scene) {
    printf("materials  %d\n", scene->material_count);
    for (int i = 0; i < scene->material_count; i++)
        print_material(&scene->materials[i], i);
    double texels = 0;
    for (int i = 0; i < scene->texture_count; i++)
        texels += (double)scene->textures[i].bitmap.width * scene->textures[i].bitmap.height;
    printf("textures   %d (%.2f megatexels)\n", scene->texture_count, texels / 1e6);
}

static void print_size(const struct emitter *light) {
    double across = (double)light->size[0];
    switch (emitter_shape(light)) {
    case EMITTER_IS_POINT:
        break;
    case EMITTER_IS_RECTANGLE:
        printf(", %.4g x %.4g m", across, (double)light->size[1]);
        break;
    case EMITTER_IS_DISK:
    case EMITTER_IS_SPHERE:
        printf(", %.4g m across", across);
        break;
    case EMITTER_IS_CAP:
        printf(", %.4g degrees across", degrees(light->size[0]));
        break;
    }
}

static void print_light(const struct scene *scene, int n) {
    struct emitter light;
    emitter_place(&light, scene, n, 0);
    const struct node *node = &scene->nodes[node_carrying(scene, NODE_LIGHT, n)];
    const struct scene_light *source = &scene->lights[node->light];
    printf("  %d  %-20s %s", n, node_name_carrying(scene, NODE_LIGHT, n),
           emitter_type_names[light.type]);
    print_vector(" ", light.intensity);
    printf(light.type == EMITTER_DIRECTIONAL ? " W/m2" : " W/sr");
    if (light.type != EMITTER_DIRECTIONAL)
        print_vector(" at ", light.position);
    if (light.type != EMITTER_POINT)
        print_vector(" towards ", light.direction);
    if (light.type == EMITTER_SPOT)
        printf(", cone %.4g to %.4g degrees", degrees(acosf(light.cos_inner)),
               degrees(acosf(light.cos_outer)));
    print_size(&light);
    if (light.slide)
        printf(", slide of %d x %d texels", light.slide->width, light.slide->height);
    if (light.stands_in)
        printf(", for a part of what emits");
    if (isfinite(source->range))
        printf(", range %.4g m", (double)source->range);
    putchar('\n');
}

static void print_camera(const struct scene *scene, int n) {
    struct camera camera;
    camera_place(&camera, scene, n, 0);
    printf("  %d  %-20s %s, ", n, node_name_carrying(scene, NODE_CAMERA, n),
           camera.orthographic ? "orthographic" : "perspective");
    if (camera.orthographic)
        printf("%.4g m high", 2 * (double)camera.y_extent);
    else
        printf("%.4g degrees high", degrees(camera.fov_y));
    const struct scene_camera *source =
        &scene->cameras[scene->nodes[node_carrying(scene, NODE_CAMERA, n)].camera];
    if (source->aspect > 0)
        printf(", aspect ratio %.4g", (double)source->aspect);
    print_vector(", at ", camera.eye);
    print_vector(" towards ", camera.forward);
    if (camera.far > 0)
        printf(", sees %.4g to %.4g m", (double)camera.near, (double)camera.far);
    else if (camera.near > 0)
        printf(", sees from %.4g m on", (double)camera.near);
    putchar('\n');
}

/* The first hundred: each is looked for among all nodes. */
static void print_each(const char *noun, const struct scene *scene, int count,
                       void (*print)(const struct scene *scene, int n)) {
    const int most = 100;
    printf("%-10s %d\n", noun, count);
    for (int n = 0; n < count && n < most; n++)
        print(scene, n);
    if (count > most)
        printf("  ... and %d more\n", count - most);
}

static void print_sky(const struct environment *sky) {
    double brightest = 0;
    for (size_t i = 0; i < (size_t)sky->width * (size_t)sky->height; i++)
        for (int c = 0; c < 3; c++)
            brightest = fmax(brightest, (double)sky->strength * (double)sky->texels[i][c]);
    printf("sky        %s, %d x %d, up to %.4g W/(sr m2), turned by %.4g degrees\n", sky->path,
           sky->width, sky->height, brightest, (double)sky->turn);
}

static void print_medium(const struct medium *medium) {
    const float *s = medium->scattering, *a = medium->absorption;
    printf("medium     scatters (%.4g, %.4g, %.4g), absorbs (%.4g, %.4g, %.4g) 1/m, g %.4g\n",
           (double)s[0], (double)s[1], (double)s[2], (double)a[0], (double)a[1], (double)a[2],
           (double)medium->g);
}

/* Counted as --light and --camera count them: by node. */
static void print_placed(const struct scene *scene) {
    print_each("lights", scene, emitter_node_count(scene), print_light);
    if (scene->environment)
        print_sky(scene->environment);
    if (medium_exists(&scene->medium))
        print_medium(&scene->medium);
    print_each("cameras", scene, camera_node_count(scene), print_camera);
}

static void print_clips(const struct scene *scene) {
    printf("clips      %d\n", scene->clip_count);
    for (int i = 0; i < scene->clip_count; i++)
        printf("  %d  %-20s %.4g s, channels %d%s\n", i, scene->clips[i].name,
               (double)scene->clips[i].duration, scene->clips[i].channel_count,
               clip_plays(scene, i) ? "" : ", only by --clip");
    if (scene->skin_count)
        printf("skins      %d\n", scene->skin_count);
    if (scene->metaballs_count)
        printf("metaballs  %d\n", scene->metaballs_count);
}

/* Of the file, where there is a choice. */
static void print_choice(const char *noun, const struct choice_list *list, int least) {
    if (list->count < least)
        return;
    printf("%-10s %d\n", noun, list->count);
    for (int i = 0; i < list->count; i++)
        printf("  %d  %-20s%s\n", i, list->names[i], i == list->shown ? " shown" : "");
}

bool scene_summary_print(const char *path, const struct scene_choice *choice) {
    struct scene scene;
    struct geometry geometry;
    const struct scene_open_desc desc = {.may_be_empty = true, .choice = *choice};
    bool ok = scene_open(&scene, &geometry, path, &desc);
    if (ok) {
        printf("scene      %s\n", path);
        print_choice("scenes", &scene.scenes, 2);
        print_choice("variants", &scene.variants, 1);
        print_meshes(&scene);
        print_left_out(&scene);
        print_geometry(&geometry);
        if (scene.origin[0] != 0 || scene.origin[1] != 0 || scene.origin[2] != 0)
            printf("origin     (%.9g, %.9g, %.9g) m: positions are relative to it\n",
                   scene.origin[0], scene.origin[1], scene.origin[2]);
        print_materials(&scene);
        print_placed(&scene);
        print_clips(&scene);
    }
    geometry_free(&geometry);
    scene_free(&scene);
    return ok;
}
