#include "library/arrays.h"

#include "base/error.h"
#include "base/memory.h"
#include "base/text.h"
#include "base/unit.h"
#include "library/desc.h"
#include "library/door.h"
#include "library/scene.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { GL_FLOAT_TYPE = 5126, GL_UNSIGNED_INT_TYPE = 5125 };

/* A GLB in the making: its lists as JSON, and the bytes behind. */
struct glb {
    struct text views, accessors, meshes, nodes, materials, pictures, textures, lights, areas,
        cameras;
    struct text bytes;
    int view_count, accessor_count, node_count, texture_count, light_count, area_count;
};

static const char *comma(const struct text *list) {
    return list->length ? "," : "";
}

static const char *text_of(const struct text *text) {
    return text->data ? text->data : "";
}

static void print_floats(struct text *to, const char *name, const float *values, int count) {
    text_print(to, "\"%s\":[", name);
    for (int i = 0; i < count; i++)
        text_print(to, "%s%.9g", i ? "," : "", (double)values[i]);
    text_print(to, "]");
}

/* --- arrays ----------------------------------------------------------------------------------- */

/* The index of a view of so many bytes, which are padded to a multiple of 4. */
static int add_view(struct glb *glb, const void *bytes, size_t size) {
    static const char zeros[4];
    text_print(&glb->views, "%s{\"buffer\":0,\"byteOffset\":%zu,\"byteLength\":%zu}",
               comma(&glb->views), glb->bytes.length, size);
    text_append(&glb->bytes, bytes, size);
    text_append(&glb->bytes, zeros, (4 - size % 4) % 4);
    return glb->view_count++;
}

static int add_accessor(struct glb *glb, const void *elements, size_t count, int width, int type) {
    static const char *const types[] = {"", "SCALAR", "VEC2", "VEC3", "VEC4"};
    int view = add_view(glb, elements, count * (size_t)width * 4);
    text_print(&glb->accessors,
               "%s{\"bufferView\":%d,\"componentType\":%d,\"count\":%zu,\"type\":\"%s\"",
               comma(&glb->accessors), view, type, count, types[width]);
    return glb->accessor_count++;
}

/* Positions have bounds, which other readers want. */
static int add_positions(struct glb *glb, const float *positions, size_t count) {
    float bounds[2][3] = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
    for (size_t i = 0; i < 3 * count; i++) {
        bounds[0][i % 3] = fminf(bounds[0][i % 3], positions[i]);
        bounds[1][i % 3] = fmaxf(bounds[1][i % 3], positions[i]);
    }
    int accessor = add_accessor(glb, positions, count, 3, GL_FLOAT_TYPE);
    if (isfinite(bounds[0][0] + bounds[0][1] + bounds[0][2] + bounds[1][0] + bounds[1][1] +
                 bounds[1][2])) {
        text_print(&glb->accessors, ",");
        print_floats(&glb->accessors, "min", bounds[0], 3);
        text_print(&glb->accessors, ",");
        print_floats(&glb->accessors, "max", bounds[1], 3);
    }
    text_print(&glb->accessors, "}");
    return accessor;
}

static void add_attribute(struct glb *glb, const char *name, const float *elements, size_t count,
                          int width) {
    if (!elements)
        return;
    text_print(&glb->meshes, ",\"%s\":%d", name,
               add_accessor(glb, elements, count, width, GL_FLOAT_TYPE));
    text_print(&glb->accessors, "}");
}

static bool refuse(const char *noun, size_t i, const char *reason) {
    error_set("%s %zu: %s", noun, i, reason);
    return door_blame(MANYLIGHT_BAD_SCENE);
}

/* The error at hand is of this part. */
static bool blame(const char *noun, size_t i) {
    error_prefix("%s %zu", noun, i);
    return door_blame(MANYLIGHT_BAD_SCENE);
}

static bool is_zero(const float *values, int count) {
    for (int i = 0; i < count; i++)
        if (values[i] != 0)
            return false;
    return true;
}

/* Error: names the vertex. Numbers above 1 are 0 .. 255, most often. */
static bool check_vertices(const struct manylight_mesh *mesh) {
    bool ok = true;
    for (size_t v = 0; ok && v < mesh->vertex_count; v++) {
        const float *normal = mesh->normals ? mesh->normals + 3 * v : NULL;
        const float *color = mesh->colors ? mesh->colors + 4 * v : NULL;
        ok = (!normal || desc_check_all("normals", normal, 3, -INFINITY, INFINITY)) &&
             (!normal || !is_zero(normal, 3) || error_set("normals: it has no length")) &&
             (!color || desc_check_all("colors", color, 4, 0, SHARE_MOST));
        ok = ok || error_prefix("vertex %zu", v);
    }
    return ok;
}

static bool check_mesh(const struct manylight_mesh *mesh, size_t i) {
    const size_t most = (size_t)1 << 31;
    if (!mesh->positions)
        return refuse("mesh", i, "positions is NULL");
    if (mesh->vertex_count >= most || mesh->index_count >= most)
        return refuse("mesh", i, "it has more than 2147483647 vertices or indices");
    return check_vertices(mesh) || blame("mesh", i);
}

static bool add_mesh(struct glb *glb, const struct manylight_scene_desc *desc, size_t i) {
    struct manylight_mesh mesh;
    if (!desc_take_element(&mesh, sizeof mesh, desc->meshes, i, "manylight_mesh") ||
        !check_mesh(&mesh, i))
        return false;
    text_print(&glb->meshes, "%s{\"primitives\":[{\"attributes\":{\"POSITION\":%d",
               comma(&glb->meshes), add_positions(glb, mesh.positions, mesh.vertex_count));
    add_attribute(glb, "NORMAL", mesh.normals, mesh.vertex_count, 3);
    add_attribute(glb, "TEXCOORD_0", mesh.uvs, mesh.vertex_count, 2);
    add_attribute(glb, "COLOR_0", mesh.colors, mesh.vertex_count, 4);
    text_print(&glb->meshes, "}");
    if (mesh.indices) {
        text_print(&glb->meshes, ",\"indices\":%d",
                   add_accessor(glb, mesh.indices, mesh.index_count, 1, GL_UNSIGNED_INT_TYPE));
        text_print(&glb->accessors, "}");
    }
    text_print(&glb->meshes, ",\"material\":%d}]}", mesh.material);
    text_print(&glb->nodes, "%s{\"mesh\":%zu}", comma(&glb->nodes), i);
    glb->node_count++;
    return true;
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

static int add_picture(struct glb *glb, const struct manylight_material *material) {
    bool is_png = picture_begins(material, png_start);
    text_print(&glb->pictures, "%s{\"bufferView\":%d,\"mimeType\":\"image/%s\"}",
               comma(&glb->pictures), add_view(glb, material->picture, material->picture_bytes),
               is_png ? "png" : "jpeg");
    text_print(&glb->textures, "%s{\"source\":%d}", comma(&glb->textures), glb->texture_count);
    return glb->texture_count++;
}

/* Factors above 1 take a strength, as files have them. */
static void print_emission(struct text *to, const float emission[3]) {
    float most = fmaxf(1, fmaxf(emission[0], fmaxf(emission[1], emission[2])));
    const float factor[] = {emission[0] / most, emission[1] / most, emission[2] / most};
    if (is_zero(emission, 3))
        return;
    text_print(to, ",");
    print_floats(to, "emissiveFactor", factor, 3);
    if (most > 1)
        text_print(
            to, ",\"extensions\":{\"KHR_materials_emissive_strength\":{\"emissiveStrength\":%.9g}}",
            (double)most);
}

/* Refuses what the reader of files would clamp: 255 for white is a mistake. */
static bool check_material(const struct manylight_material *material) {
    bool is_smooth = material->roughness == MANYLIGHT_ZERO;
    return desc_check_all("base_color", material->base_color, 4, 0, SHARE_MOST) &&
           desc_check("metalness", (double)material->metalness, 0, SHARE_MOST) &&
           (is_smooth || desc_check("roughness", (double)material->roughness, 0, SHARE_MOST)) &&
           desc_check_all("emission", material->emission, 3, 0, INFINITY) &&
           (!material->picture || picture_is_encoded(material) ||
            error_set("picture: its bytes are neither PNG nor JPEG"));
}

static bool add_material(struct glb *glb, const struct manylight_scene_desc *desc, size_t i) {
    static const float white[4] = {1, 1, 1, 1};
    struct manylight_material material;
    if (!desc_take_element(&material, sizeof material, desc->materials, i, "manylight_material"))
        return false;
    if (!check_material(&material))
        return blame("material", i);
    float roughness = material.roughness == 0                ? 1
                      : material.roughness == MANYLIGHT_ZERO ? 0
                                                             : material.roughness;
    struct text *to = &glb->materials;
    text_print(to, "%s{\"pbrMetallicRoughness\":{", comma(to));
    print_floats(to, "baseColorFactor",
                 is_zero(material.base_color, 4) ? white : material.base_color, 4);
    text_print(to, ",\"metallicFactor\":%.9g,\"roughnessFactor\":%.9g", (double)material.metalness,
               (double)roughness);
    if (material.picture)
        text_print(to, ",\"baseColorTexture\":{\"index\":%d}", add_picture(glb, &material));
    text_print(to, "},\"doubleSided\":%s", material.double_sided ? "true" : "false");
    print_emission(to, material.emission);
    text_print(to, "}");
    return true;
}

/* --- lights and cameras ----------------------------------------------------------------------- */

/* A node that looks along a direction. */
static void add_node(struct glb *glb, const float eye[3], const float right[3], const float up[3],
                     const float forward[3], const char *carries) {
    const float matrix[] = {right[0],    right[1],    right[2],    0, up[0],  up[1],  up[2],  0,
                            -forward[0], -forward[1], -forward[2], 0, eye[0], eye[1], eye[2], 1};
    text_print(&glb->nodes, "%s{", comma(&glb->nodes));
    print_floats(&glb->nodes, "matrix", matrix, 16);
    text_print(&glb->nodes, ",%s}", carries);
    glb->node_count++;
}

/* An orthonormal frame of a direction and of what shall be up; 0: chosen. False: up is along the
 * direction. */
static bool make_frame(const float direction[3], const float wanted[3], vec3 right, vec3 up,
                       vec3 forward) {
    vec3 above;
    vec3_unit_to((float *)direction, forward);
    glm_vec3_copy((float *)wanted, above);
    if (is_zero(above, 3))
        above[fabsf(forward[1]) > .999F ? 2 : 1] = 1;
    vec3_unit_cross(forward, above, right);
    glm_vec3_cross(right, forward, up);
    return !is_zero(right, 3);
}

/* Extents as the extras and the extension of files have them. */
static void print_extent(struct text *to, const struct manylight_light *light) {
    const float *extent = light->extent;
    if (is_zero(extent, 2))
        return;
    if (light->type == MANYLIGHT_DIRECTIONAL)
        text_print(to, ",\"extras\":{\"angle\":%.9g}", (double)extent[0]);
    else if (light->type == MANYLIGHT_SPOT && extent[1] != 0)
        text_print(to, ",\"extras\":{\"size\":[%.9g,%.9g]}", (double)extent[0], (double)extent[1]);
    else
        text_print(to, ",\"extras\":{\"radius\":%.9g}", (double)extent[0] / 2);
}

static void print_area(struct text *to, const struct manylight_light *light) {
    const float *extent = light->extent;
    if (extent[1] != 0)
        text_print(to, ",\"type\":\"rect\",\"size\":%.9g,\"rect\":{\"aspect\":%.9g}",
                   (double)extent[1], (double)extent[0] / (double)extent[1]);
    else
        text_print(to, ",\"type\":\"disk\",\"size\":%.9g", (double)extent[0]);
}

/* m2 */
static double area_of(const struct manylight_light *light) {
    double across = (double)light->extent[0], high = (double)light->extent[1];
    return high != 0 ? across * high : GLM_PI / 4 * across * across;
}

/* Files have the radiance of an area light. */
static void print_light(struct text *to, const struct manylight_light *light) {
    static const char *const types[] = {"spot", "point", "directional"};
    double area = light->type == MANYLIGHT_AREA ? area_of(light) : 1;
    text_print(to, "%s{", comma(to));
    float most = fmaxf(light->intensity[0], fmaxf(light->intensity[1], light->intensity[2]));
    most = most > 0 ? most : 1; /* what is negative is refused as in a file */
    float color[3];
    for (int c = 0; c < 3; c++)
        color[c] = light->intensity[c] / most;
    print_floats(to, "color", color, 3);
    text_print(to, ",\"intensity\":%.9g", (double)most / area);
    if (light->type == MANYLIGHT_AREA) {
        print_area(to, light);
    } else {
        text_print(to, ",\"type\":\"%s\"", types[light->type]);
        if (light->type == MANYLIGHT_SPOT)
            text_print(to, ",\"spot\":{\"innerConeAngle\":%.9g,\"outerConeAngle\":%.9g}",
                       (double)light->inner_angle,
                       light->outer_angle == 0 ? GLM_PI_4 : (double)light->outer_angle);
        print_extent(to, light);
    }
    text_print(to, "}");
}

static bool check_light(const struct manylight_light *light) {
    if ((unsigned)light->type > MANYLIGHT_AREA)
        return error_set("type: %d is none of enum manylight_light_type", (int)light->type);
    return desc_check_all("position", light->position, 3, -INFINITY, INFINITY) &&
           desc_check_all("direction", light->direction, 3, -INFINITY, INFINITY) &&
           desc_check_all("up", light->up, 3, -INFINITY, INFINITY) &&
           desc_check_all("intensity", light->intensity, 3, 0, INFINITY) &&
           desc_check_all("extent", light->extent, 2, 0, INFINITY) &&
           desc_check("inner_angle", (double)light->inner_angle, 0, INFINITY) &&
           desc_check("outer_angle", (double)light->outer_angle, 0, INFINITY) &&
           (light->type != MANYLIGHT_AREA || light->extent[0] > 0 ||
            error_set("extent: an area light has a width"));
}

static bool add_light(struct glb *glb, const struct manylight_scene_desc *desc, size_t i) {
    struct manylight_light light;
    char carries[96];
    vec3 right, up, forward;
    if (!desc_take_element(&light, sizeof light, desc->lights, i, "manylight_light"))
        return false;
    if (!check_light(&light))
        return blame("light", i);
    bool is_area = light.type == MANYLIGHT_AREA;
    if (is_zero(light.direction, 3))
        light.direction[1] = -1;
    if (!make_frame(light.direction, light.up, right, up, forward))
        return refuse("light", i, "up is along direction");
    print_light(is_area ? &glb->areas : &glb->lights, &light);
    snprintf(carries, sizeof carries, "\"extensions\":{\"%s\":{\"light\":%d}}",
             is_area ? "EXT_lights_area" : "KHR_lights_punctual",
             is_area ? glb->area_count++ : glb->light_count++);
    add_node(glb, light.position, right, up, forward, carries);
    return true;
}

static bool add_camera(struct glb *glb, const struct manylight_scene_desc *desc, size_t i) {
    struct manylight_camera camera;
    char carries[32];
    vec3 right, up, forward;
    if (!desc_take_element(&camera, sizeof camera, desc->cameras, i, "manylight_camera"))
        return false;
    if (!check_camera(&camera))
        return blame("camera", i);
    if (is_zero(camera.forward, 3))
        camera.forward[2] = -1;
    bool has_frame = make_frame(camera.forward, camera.up, right, up, forward);
    if (!has_frame)
        return refuse("camera", i, "up is along forward");
    if (!is_zero(camera.right, 3) && glm_vec3_distance(camera.right, right) > 2e-3F)
        return refuse("camera", i, "right is not that of forward and up");
    if (camera.shift[0] != 0 || camera.shift[1] != 0)
        return refuse("camera", i, "shift: for cameras of views, not of scenes");
    struct text *to = &glb->cameras;
    bool orthographic = camera.fov_y == 0 && camera.y_extent != 0;
    double fov_y = camera.fov_y == 0 ? .8 : (double)camera.fov_y, extent = (double)camera.y_extent;
    if (orthographic)
        text_print(to,
                   "%s{\"type\":\"orthographic\",\"orthographic\":{\"xmag\":%.9g,\"ymag\":%.9g,",
                   comma(to), extent, extent);
    else
        text_print(to, "%s{\"type\":\"perspective\",\"perspective\":{\"yfov\":%.9g,", comma(to),
                   fov_y);
    text_print(to, "\"znear\":%.9g", (double)camera.near_plane);
    if (camera.far_plane != 0 || orthographic)
        text_print(to, ",\"zfar\":%.9g", camera.far_plane != 0 ? (double)camera.far_plane : 1e30);
    text_print(to, "}}");
    snprintf(carries, sizeof carries, "\"camera\":%zu", i);
    add_node(glb, camera.eye, right, up, forward, carries);
    return true;
}

/* --- the whole -------------------------------------------------------------------------------- */

static void print_list(struct text *json, const char *name, const struct text *list) {
    if (list->length)
        text_print(json, ",\"%s\":[%s]", name, text_of(list));
}

static void print_json(const struct glb *glb, struct text *json) {
    text_print(json,
               "{\"asset\":{\"version\":\"2.0\"},\"extensionsUsed\":[\"KHR_lights_punctual\","
               "\"EXT_lights_area\",\"KHR_materials_emissive_strength\"],\"extensions\":{"
               "\"KHR_lights_punctual\":{\"lights\":[%s]},\"EXT_lights_area\":{\"lights\":[%s]}}",
               text_of(&glb->lights), text_of(&glb->areas));
    print_list(json, "materials", &glb->materials);
    print_list(json, "meshes", &glb->meshes);
    print_list(json, "nodes", &glb->nodes);
    print_list(json, "cameras", &glb->cameras);
    print_list(json, "images", &glb->pictures);
    print_list(json, "textures", &glb->textures);
    print_list(json, "accessors", &glb->accessors);
    print_list(json, "bufferViews", &glb->views);
    text_print(json, ",\"buffers\":[{\"byteLength\":%zu}],\"scene\":0,\"scenes\":[{\"nodes\":[",
               glb->bytes.length);
    for (int i = 0; i < glb->node_count; i++)
        text_print(json, "%s%d", i ? "," : "", i);
    text_print(json, "]}]}");
    while (json->length % 4)
        text_print(json, " ");
}

static void append_word(struct text *to, size_t number) {
    uint32_t word = (uint32_t)number;
    text_append(to, &word, sizeof word);
}

static bool pack(struct glb *glb, struct file_bytes *bytes) {
    struct text json = {0}, file = {0};
    print_json(glb, &json);
    size_t size = 28 + json.length + glb->bytes.length;
    if (size > UINT32_MAX) {
        free(json.data);
        return error_set("arrays: %zu bytes are more than the 4 GiB of a scene", size);
    }
    text_append(&file, "glTF", 4);
    append_word(&file, 2);
    append_word(&file, size);
    append_word(&file, json.length);
    text_append(&file, "JSON", 4);
    text_append(&file, json.data, json.length);
    append_word(&file, glb->bytes.length);
    text_append(&file, "BIN", 4);
    text_append(&file, text_of(&glb->bytes), glb->bytes.length);
    free(json.data);
    *bytes = (struct file_bytes){(unsigned char *)file.data, file.length};
    return true;
}

typedef bool add_one(struct glb *glb, const struct manylight_scene_desc *desc, size_t i);

static bool add_all(struct glb *glb, const struct manylight_scene_desc *desc, const void *array,
                    size_t count, add_one *add) {
    bool ok = true;
    if (count > 0 && !array) {
        error_set("manylight_scene_desc: a list of %zu parts is NULL", count);
        return door_blame(MANYLIGHT_BAD_ARGUMENT);
    }
    for (size_t i = 0; ok && i < count; i++)
        ok = add(glb, desc, i);
    return ok;
}

/* What the arrays take twice, as GLB and as it grows. */
static bool check_memory(const struct manylight_scene_desc *desc) {
    uint64_t bytes = 0;
    for (size_t i = 0; i < desc->mesh_count; i++) {
        struct manylight_mesh mesh;
        if (!desc_take_element(&mesh, sizeof mesh, desc->meshes, i, "manylight_mesh"))
            return false;
        bytes += 48 * (uint64_t)mesh.vertex_count + 4 * (uint64_t)mesh.index_count;
    }
    return mem_check(3 * bytes) || error_prefix("arrays");
}

bool arrays_to_glb(const struct manylight_scene_desc *desc, struct file_bytes *bytes) {
    struct glb glb = {.view_count = 0};
    struct text *lists[] = {&glb.views,     &glb.accessors, &glb.meshes,   &glb.nodes,
                            &glb.materials, &glb.pictures,  &glb.textures, &glb.lights,
                            &glb.areas,     &glb.cameras,   &glb.bytes};
    if (desc->material_count == 0) /* that of files without any is a metal */
        text_print(&glb.materials, "{\"pbrMetallicRoughness\":{\"metallicFactor\":0}}");
    bool ok = check_memory(desc) &&
              add_all(&glb, desc, desc->materials, desc->material_count, add_material) &&
              add_all(&glb, desc, desc->meshes, desc->mesh_count, add_mesh) &&
              add_all(&glb, desc, desc->lights, desc->light_count, add_light) &&
              add_all(&glb, desc, desc->cameras, desc->camera_count, add_camera) &&
              pack(&glb, bytes);
    for (size_t i = 0; i < sizeof lists / sizeof *lists; i++)
        free(lists[i]->data);
    return ok;
}
