#include "library/arrays.h"

#include "base/error.h"
#include "base/file/image_file.h"
#include "base/memory.h"
#include "base/unit.h"
#include "library/desc.h"
#include "library/door.h"
#include "library/scene.h"
#include "scene/material.h"
#include "scene/mesh/primitive.h"
#include "scene/node.h"
#include "scene/read_rules.h"
#include "scene/texture.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static struct node *add_node(struct scene *scene) {
    struct node *node = &scene->nodes[scene->node_count++];
    *node = node_new();
    return node;
}

/* Places a node that looks along a direction. wanted: what shall be up; 0: chosen. Error: it is
 * along the direction. */
static bool aim_node(struct node *node, const float eye[3], const float direction[3],
                     const float wanted[3], const char *name) {
    vec3 above, right, up, forward;
    vec3_unit_to((float *)direction, forward);
    glm_vec3_copy((float *)wanted, above);
    if (desc_is_zero(above, 3))
        above[fabsf(forward[1]) > .999F ? 2 : 1] = 1;
    vec3_unit_cross(forward, above, right);
    glm_vec3_cross(right, forward, up);
    const float matrix[] = {right[0],    right[1],    right[2],    0, up[0],  up[1],  up[2],  0,
                            -forward[0], -forward[1], -forward[2], 0, eye[0], eye[1], eye[2], 1};
    node->has_matrix = true;
    memcpy(node->matrix, matrix, sizeof matrix);
    return !desc_is_zero(right, 3) || error_set("up is along %s", name);
}

/* --- meshes ----------------------------------------------------------------------------------- */

/* Error: names the vertex. Numbers above 1 are 0 .. 255, most often. */
static bool check_vertices(const struct manylight_mesh *mesh) {
    bool ok = true;
    for (size_t v = 0; ok && v < mesh->vertex_count; v++) {
        const float *normal = mesh->normals ? mesh->normals + 3 * v : NULL;
        const float *color = mesh->colors ? mesh->colors + 4 * v : NULL;
        const float *uv = mesh->uvs ? mesh->uvs + 2 * v : NULL;
        ok = (!normal || desc_check_all("normals", normal, 3, -INFINITY, INFINITY)) &&
             (!normal || !desc_is_zero(normal, 3) || error_set("normals: it has no length")) &&
             (!color || desc_check_all("colors", color, 4, 0, SHARE_MOST)) &&
             (!uv || desc_check_all("uvs", uv, 2, -INFINITY, INFINITY));
        ok = ok || error_prefix("vertex %zu", v);
    }
    return ok;
}

static bool check_mesh(const struct manylight_mesh *mesh) {
    const size_t most = (size_t)1 << 31;
    if (!mesh->positions)
        return error_set("positions is NULL");
    if (mesh->vertex_count >= most || mesh->index_count >= most)
        return error_set("it has more than 2147483647 vertices or indices");
    /* A flat mesh has three vertices of its own for each triangle. */
    size_t count = mesh->indices ? mesh->index_count : mesh->vertex_count;
    return mem_check(48 * ((uint64_t)mesh->vertex_count + 2 * (uint64_t)count)) &&
           check_vertices(mesh);
}

static bool fill_primitive(struct primitive *to, const struct manylight_mesh *mesh,
                           bool has_picture) {
    size_t count = mesh->vertex_count;
    to->vertex_count = (int)count;
    to->position = mem_copy(mesh->positions, count, sizeof *to->position);
    to->normal = mem_copy(mesh->normals, count, sizeof *to->normal);
    to->uv[0] = has_picture ? mem_copy(mesh->uvs, count, sizeof *to->uv[0]) : NULL;
    to->color = mem_copy(mesh->colors, count, sizeof *to->color);
    to->index_count = (int)(mesh->indices ? mesh->index_count : count);
    to->indices = mesh->indices ? mem_copy(mesh->indices, mesh->index_count, sizeof *to->indices)
                                : mem_alloc(count, sizeof *to->indices);
    for (size_t i = 0; !mesh->indices && i < count; i++)
        to->indices[i] = (uint32_t)i;
    if (!primitive_check(to) || !primitive_unroll(to, PRIMITIVE_TRIANGLES))
        return false;
    if (to->normal)
        primitive_repair_normals(to);
    else
        primitive_flatten(to, 0);
    return true;
}

bool arrays_set_mesh(struct mesh *to, const struct manylight_mesh *mesh, int material,
                     bool has_picture) {
    struct primitive filled = {.material = material};
    size_t indices = mesh->indices ? mesh->index_count : mesh->vertex_count;
    if (!check_mesh(mesh))
        return false;
    if (indices == 0 && read_rules_are_strict())
        return error_set("it has no triangle");
    if (indices > 0 && !fill_primitive(&filled, mesh, has_picture)) {
        primitive_free(&filled, 0);
        return false;
    }
    primitive_free(to->primitives, 0);
    *to->primitives = filled;
    to->primitive_count = indices > 0;
    return true;
}

static bool fill_mesh(struct scene *scene, const struct manylight_scene_desc *desc, size_t i) {
    struct manylight_mesh mesh;
    if (!desc_take_element(&mesh, sizeof mesh, desc->meshes, i, "manylight_mesh"))
        return false;
    /* The last material is the default of files. */
    if (mesh.material < 0 || mesh.material >= scene->material_count - 1)
        return error_set("material: %d is not from 0 to %d", mesh.material,
                         scene->material_count - 2);
    struct mesh *to = &scene->meshes[scene->mesh_count++];
    to->primitives = mem_alloc(1, sizeof *to->primitives);
    add_node(scene)->mesh = (int)i;
    return arrays_set_mesh(to, &mesh, mesh.material,
                           scene->materials[mesh.material].base_color_texture >= 0);
}

/* --- materials -------------------------------------------------------------------------------- */

static bool picture_begins(const struct manylight_material *material, const char *with) {
    size_t length = strlen(with);
    return material->picture_bytes >= length && memcmp(material->picture, with, length) == 0;
}

static const char png_start[] = "\x89PNG", jpeg_start[] = "\xff\xd8\xff";

static bool picture_is_encoded(const struct manylight_material *material) {
    return picture_begins(material, png_start) || picture_begins(material, jpeg_start);
}

/* Refuses numbers that files would clamp: 255 for white is a mistake. */
static bool check_material(const struct manylight_material *material) {
    bool is_smooth = material->roughness == MANYLIGHT_ZERO;
    return desc_check_all("base_color", material->base_color, 4, 0, SHARE_MOST) &&
           desc_check("metalness", (double)material->metalness, 0, SHARE_MOST) &&
           (is_smooth || desc_check("roughness", (double)material->roughness, 0, SHARE_MOST)) &&
           desc_check_all("emission", material->emission, 3, 0, (double)SCENE_LIGHT_MOST) &&
           (!material->picture || picture_is_encoded(material) ||
            error_set("picture: its bytes are neither PNG nor JPEG"));
}

static bool fill_picture(struct scene *scene, const struct manylight_material *material) {
    struct scene_texture *texture = &scene->textures[scene->texture_count];
    uint64_t memory;
    if (!bitmap_measure(material->picture, material->picture_bytes, &memory) ||
        !mem_check(memory) ||
        !bitmap_decode(&texture->bitmap, material->picture, material->picture_bytes))
        return error_prefix("picture");
    texture_shrink(texture, TEXTURE_SIDE_MAX);
    scene->texture_count++;
    return true;
}

bool arrays_set_material(struct material *to, const struct manylight_material *material) {
    static const float white[4] = {1, 1, 1, 1};
    if (!check_material(material))
        return false;
    memcpy(to->base_color, desc_is_zero(material->base_color, 4) ? white : material->base_color,
           sizeof to->base_color);
    to->metalness = material->metalness;
    to->roughness = material->roughness == 0                ? 1
                    : material->roughness == MANYLIGHT_ZERO ? 0
                                                            : material->roughness;
    to->double_sided = material->double_sided != 0;
    memcpy(to->emission, material->emission, sizeof to->emission);
    memcpy(to->emissive_factor, material->emission, sizeof to->emission);
    to->emissive_strength = 1;
    return true;
}

static bool fill_material(struct scene *scene, const struct manylight_scene_desc *desc, size_t i) {
    struct manylight_material material;
    struct material *to = &scene->materials[i];
    material_init(to, "");
    if (!desc_take_element(&material, sizeof material, desc->materials, i, "manylight_material") ||
        !arrays_set_material(to, &material))
        return false;
    if (!material.picture)
        return true;
    to->base_color_texture = scene->texture_count;
    return fill_picture(scene, &material);
}

/* --- lights and cameras ----------------------------------------------------------------------- */

/* m2 */
static double area_of(const struct manylight_light *light) {
    double across = (double)light->extent[0], high = (double)light->extent[1];
    return high != 0 ? across * high : GLM_PI / 4 * across * across;
}

/* An area light has radiance. */
static void fill_intensity(const struct manylight_light *light, struct scene_light *to) {
    double area = light->type == MANYLIGHT_AREA ? area_of(light) : 1;
    to->strength = to->scale = 1;
    for (int c = 0; c < 3; c++)
        to->intensity[c] = to->color[c] = (float)((double)light->intensity[c] / area);
}

static bool check_light(const struct manylight_light *light) {
    if ((unsigned)light->type > MANYLIGHT_AREA)
        return error_set("type: %d is none of enum manylight_light_type", (int)light->type);
    bool is_angle = light->type == MANYLIGHT_DIRECTIONAL;
    double outer = light->outer_angle == 0 ? GLM_PI_4 : (double)light->outer_angle;
    return desc_check_all("position", light->position, 3, -INFINITY, INFINITY) &&
           desc_check_all("direction", light->direction, 3, -INFINITY, INFINITY) &&
           desc_check_all("up", light->up, 3, -INFINITY, INFINITY) &&
           desc_check_all("intensity", light->intensity, 3, 0, INFINITY) &&
           desc_check_all("extent", light->extent, 2, 0, is_angle ? 3.1416 : 1e9) &&
           desc_check("outer_angle", outer, 0, 1.5708) &&
           desc_check("inner_angle", (double)light->inner_angle, 0, outer * 1.00001) &&
           (light->extent[0] > 0 || (light->type != MANYLIGHT_AREA && light->extent[1] == 0) ||
            error_set("extent: the width is 0"));
}

static bool fill_light(struct scene *scene, const struct manylight_scene_desc *desc, size_t i) {
    static const enum emitter_type types[] = {EMITTER_SPOT, EMITTER_POINT, EMITTER_DIRECTIONAL,
                                              EMITTER_AREA};
    struct scene_light *to = &scene->lights[scene->light_count];
    struct manylight_light light;
    struct node *node = add_node(scene);
    node->light = scene->light_count++;
    if (!desc_take_element(&light, sizeof light, desc->lights, i, "manylight_light") ||
        !check_light(&light))
        return false;
    bool is_area = light.type == MANYLIGHT_AREA, is_spot = light.type == MANYLIGHT_SPOT;
    to->type = types[light.type];
    to->range = INFINITY;
    to->scaling = is_area ? LIGHT_SCALED_ALIKE : LIGHT_NOT_SCALED;
    to->outer = light.outer_angle == 0 ? GLM_PI_4f : fminf(light.outer_angle, GLM_PI_2f);
    to->outer = is_area ? GLM_PI_2f : is_spot ? to->outer : 0;
    to->inner = is_spot ? fminf(light.inner_angle, to->outer) : 0;
    to->size[0] = light.extent[0];
    to->size[1] = is_area || is_spot ? light.extent[1] : 0;
    fill_intensity(&light, to);
    if (desc_is_zero(light.direction, 3))
        light.direction[1] = -1;
    return desc_check_all("intensity", to->intensity, 3, 0, (double)SCENE_LIGHT_MOST) &&
           aim_node(node, light.position, light.direction, light.up, "direction");
}

static bool check_scene_camera(const struct manylight_camera *camera, const struct node *node) {
    if (!desc_is_zero(camera->right, 3) &&
        glm_vec3_distance((float *)camera->right, (float *)node->matrix) > 2e-3F)
        return error_set("right is not that of forward and up");
    if (camera->lens != MANYLIGHT_LENS_PINHOLE || camera->skew != 0 ||
        !desc_is_zero(camera->distortion, 8))
        return error_set("lens, skew and distortion: for cameras of views, not of scenes");
    return desc_is_zero(camera->shift, 2) ||
           error_set("shift: for cameras of views, not of scenes");
}

static bool fill_camera(struct scene *scene, const struct manylight_scene_desc *desc, size_t i) {
    struct manylight_camera camera;
    if (!desc_take_element(&camera, sizeof camera, desc->cameras, i, "manylight_camera") ||
        !check_camera(&camera))
        return false;
    if (desc_is_zero(camera.forward, 3))
        camera.forward[2] = -1;
    struct scene_camera *to = &scene->cameras[scene->camera_count++];
    struct node *node = add_node(scene);
    node->camera = (int)i;
    to->orthographic = camera.fov_y == 0 && camera.y_extent != 0;
    to->fov_y = to->orthographic ? 0 : camera.fov_y == 0 ? .8F : camera.fov_y;
    to->y_extent = to->orthographic ? camera.y_extent : 0;
    to->aspect = to->orthographic;
    to->near = camera.near_plane;
    to->far = camera.far_plane;
    return aim_node(node, camera.eye, camera.forward, camera.up, "forward") &&
           check_scene_camera(&camera, node);
}

/* --- the whole -------------------------------------------------------------------------------- */

typedef bool fill_one(struct scene *scene, const struct manylight_scene_desc *desc, size_t i);

static bool fill_all(struct scene *scene, const struct manylight_scene_desc *desc,
                     const void *array, size_t count, const char *noun, fill_one *fill) {
    bool ok = true;
    if (count > 0 && !array) {
        error_set("manylight_scene_desc: a list of %zu parts is NULL", count);
        return door_blame(MANYLIGHT_BAD_ARGUMENT);
    }
    for (size_t i = 0; ok && i < count; i++)
        ok = fill(scene, desc, i) || error_prefix("%s %zu", noun, i);
    return ok;
}

/* White, if there are none; and the default of files, behind them. */
static void make_materials(struct scene *scene, size_t count) {
    scene->material_count = (int)(count ? count : 1) + 1;
    scene->materials = mem_alloc((size_t)scene->material_count, sizeof *scene->materials);
    scene->textures = mem_alloc(count, sizeof *scene->textures);
    material_init(&scene->materials[0], "");
    scene->materials[0].metalness = 0;
    material_init(&scene->materials[scene->material_count - 1], "default");
}

bool arrays_fill(const struct manylight_scene_desc *desc, struct scene *scene) {
    size_t nodes = desc->mesh_count + desc->light_count + desc->camera_count;
    const size_t most = (size_t)1 << 24;
    *scene = (struct scene){.path = mem_strdup("arrays")};
    if (nodes > most || desc->material_count > most)
        return error_set("arrays: more than %zu parts", most);
    scene->nodes = mem_alloc(nodes, sizeof *scene->nodes);
    scene->meshes = mem_alloc(desc->mesh_count, sizeof *scene->meshes);
    scene->lights = mem_alloc(desc->light_count, sizeof *scene->lights);
    scene->cameras = mem_alloc(desc->camera_count, sizeof *scene->cameras);
    make_materials(scene, desc->material_count);
    return (fill_all(scene, desc, desc->materials, desc->material_count, "material",
                     fill_material) &&
            fill_all(scene, desc, desc->meshes, desc->mesh_count, "mesh", fill_mesh) &&
            fill_all(scene, desc, desc->lights, desc->light_count, "light", fill_light) &&
            fill_all(scene, desc, desc->cameras, desc->camera_count, "camera", fill_camera)) ||
           error_prefix("arrays");
}
