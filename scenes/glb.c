#define _POSIX_C_SOURCE 200809L
#include "glb.h"

#include "base/unit.h"
#include "png.h"

#include "base/file/file.h"
#include "base/file/output_file.h"
#include "base/memory.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Numbers of the glTF and GLB specifications. */
enum {
    COMPONENT_UINT8 = 5121,
    COMPONENT_UINT16 = 5123,
    COMPONENT_UINT32 = 5125,
    COMPONENT_FLOAT = 5126,
    TARGET_VERTICES = 34962,
    TARGET_INDICES = 34963,
    GLB_MAGIC = 0x46546C67,
    CHUNK_JSON = 0x4E4F534A,
    CHUNK_BINARY = 0x004E4942,
};

/* --- elements -------------------------------------------------------------------------------- */

/* Begins the next element of an array; returns its index. */
static int next_element(struct text *array, int *count) {
    if (*count > 0)
        text_append(array, ",\n", 2);
    return (*count)++;
}

/* Begins the next node; returns its index. */
static int next_node(struct glb *glb, int parent) {
    int index = next_element(&glb->nodes, &glb->node_count);
    glb->hierarchy = mem_resize(glb->hierarchy, (size_t)glb->node_count, sizeof *glb->hierarchy);
    glb->hierarchy[index] = (struct glb_node){glb->nodes.length, parent};
    return index;
}

static void text_pad(struct text *text, char with) {
    while (text->length % 4)
        text_append(text, &with, 1);
}

void glb_init(struct glb *glb, const char *name) {
    *glb = (struct glb){.name = name};
}

void glb_free(struct glb *glb) {
    struct text *texts[] = {&glb->nodes,    &glb->meshes,          &glb->materials, &glb->accessors,
                            &glb->views,    &glb->cameras,         &glb->lights,    &glb->binary,
                            &glb->skins,    &glb->channels,        &glb->samplers,  &glb->images,
                            &glb->textures, &glb->texture_samplers};
    for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++)
        free(texts[i]->data);
    free(glb->hierarchy);
    *glb = (struct glb){0};
}

/* --- materials and meshes --------------------------------------------------------------------- */

static int add_material(struct glb *glb, const char *name, const float color[3], float metalness,
                        float roughness, enum glb_sides sides) {
    int index = next_element(&glb->materials, &glb->material_count);
    text_print(&glb->materials,
               "{\"name\":\"%s\",\"pbrMetallicRoughness\":{\"baseColorFactor\":[%.9g,%.9g,%.9g,1],"
               "\"metallicFactor\":%.9g,\"roughnessFactor\":%.9g}%s}",
               name, color[0], color[1], color[2], metalness, roughness,
               sides == GLB_DOUBLE_SIDED ? ",\"doubleSided\":true" : "");
    return index;
}

int glb_add_material(struct glb *glb, const char *name, const float albedo[3],
                     enum glb_sides sides) {
    return add_material(glb, name, albedo, 0, 1, sides);
}

int glb_add_specular(struct glb *glb, const char *name, const float color[3], float metalness,
                     float roughness) {
    return add_material(glb, name, color, metalness, roughness, GLB_SINGLE_SIDED);
}

int glb_add_glass(struct glb *glb, const char *name, float index_of_refraction, float distance,
                  const float color[3]) {
    int index = next_element(&glb->materials, &glb->material_count);
    text_print(&glb->materials,
               "{\"name\":\"%s\",\"pbrMetallicRoughness\":{\"metallicFactor\":0,"
               "\"roughnessFactor\":0},\"extensions\":{\"KHR_materials_transmission\":"
               "{\"transmissionFactor\":1},\"KHR_materials_ior\":{\"ior\":%.9g},"
               "\"KHR_materials_volume\":{\"thicknessFactor\":1,\"attenuationDistance\":%.9g,"
               "\"attenuationColor\":[%.9g,%.9g,%.9g]}}}",
               name, index_of_refraction, distance, color[0], color[1], color[2]);
    glb->has_glass = true;
    return index;
}

int glb_add_lamp(struct glb *glb, const char *name, const float radiance[3]) {
    int index = next_element(&glb->materials, &glb->material_count);
    float strength = glm_vec3_max((float *)radiance);
    text_print(&glb->materials,
               "{\"name\":\"%s\",\"pbrMetallicRoughness\":{\"baseColorFactor\":[0.5,0.5,0.5,1],"
               "\"metallicFactor\":0,\"roughnessFactor\":1},\"emissiveFactor\":[%.9g,%.9g,%.9g],"
               "\"extensions\":{\"KHR_materials_emissive_strength\":{\"emissiveStrength\":%.9g}}}",
               name, radiance[0] / strength, radiance[1] / strength, radiance[2] / strength,
               strength);
    glb->has_lamps = true;
    return index;
}

static int add_view(struct glb *glb, const void *bytes, size_t size, int target) {
    int index = next_element(&glb->views, &glb->view_count);
    text_print(&glb->views, "{\"buffer\":0,\"byteOffset\":%zu,\"byteLength\":%zu",
               glb->binary.length, size);
    if (target)
        text_print(&glb->views, ",\"target\":%d", target);
    text_append(&glb->views, "}", 1);
    text_append(&glb->binary, bytes, size);
    text_pad(&glb->binary, '\0');
    return index;
}

/* The least and the greatest of each component, as the standard asks of positions and times. */
static void print_bounds(struct glb *glb, const float *numbers, int width, uint32_t count) {
    for (int greatest = 0; greatest < 2; greatest++) {
        text_print(&glb->accessors, greatest ? "],\"max\":[" : ",\"min\":[");
        for (int c = 0; c < width; c++) {
            float bound = numbers[c];
            for (uint32_t i = 1; i < count; i++) {
                float x = numbers[i * (uint32_t)width + (uint32_t)c];
                bound = greatest ? fmaxf(bound, x) : fminf(bound, x);
            }
            text_print(&glb->accessors, "%s%.9g", c ? "," : "", bound);
        }
    }
    text_append(&glb->accessors, "]", 1);
}

enum { NO_BOUNDS, BOUNDS };

static int add_floats(struct glb *glb, const float *numbers, int width, uint32_t count, int target,
                      int bounds) {
    static const char *const types[] = {
        [1] = "SCALAR", [2] = "VEC2", [3] = "VEC3", [4] = "VEC4", [16] = "MAT4"};
    int view = add_view(glb, numbers, count * (size_t)width * sizeof *numbers, target);
    int index = next_element(&glb->accessors, &glb->accessor_count);
    text_print(&glb->accessors,
               "{\"bufferView\":%d,\"componentType\":%d,\"count\":%u,\"type\":\"%s\"", view,
               COMPONENT_FLOAT, count, types[width]);
    if (bounds)
        print_bounds(glb, numbers, width, count);
    text_append(&glb->accessors, "}", 1);
    return index;
}

/* As 16-bit integers where the vertices allow it. */
static int add_indices(struct glb *glb, const struct surface *surface) {
    uint32_t count = surface->index_count;
    bool small = surface->vertex_count <= UINT16_MAX;
    int view;
    if (small) {
        uint16_t *indices = mem_alloc(count, sizeof *indices);
        for (uint32_t i = 0; i < count; i++)
            indices[i] = (uint16_t)surface->indices[i];
        view = add_view(glb, indices, count * sizeof *indices, TARGET_INDICES);
        free(indices);
    } else {
        view = add_view(glb, surface->indices, count * sizeof *surface->indices, TARGET_INDICES);
    }
    int index = next_element(&glb->accessors, &glb->accessor_count);
    text_print(&glb->accessors,
               "{\"bufferView\":%d,\"componentType\":%d,\"count\":%u,\"type\":\"SCALAR\"}", view,
               small ? COMPONENT_UINT16 : COMPONENT_UINT32, count);
    return index;
}

/* `more` is JSON of further attributes. */
static int add_surface(struct glb *glb, const char *name, const struct surface *surface,
                       int material, const char *more) {
    int position =
        add_floats(glb, *surface->position, 3, surface->vertex_count, TARGET_VERTICES, BOUNDS);
    int normal =
        add_floats(glb, *surface->normal, 3, surface->vertex_count, TARGET_VERTICES, NO_BOUNDS);
    int indices = add_indices(glb, surface);
    int mesh = next_element(&glb->meshes, &glb->mesh_count);
    text_print(&glb->meshes,
               "{\"name\":\"%s\",\"primitives\":[{\"attributes\":{\"POSITION\":%d,\"NORMAL\":%d%s},"
               "\"indices\":%d,\"material\":%d}]}",
               name, position, normal, more, indices, material);
    return mesh;
}

int glb_add_mesh(struct glb *glb, const char *name, const struct surface *surface, int material,
                 const char *extras) {
    if (surface->index_count == 0)
        return -1;
    int mesh = add_surface(glb, name, surface, material, "");
    int node = next_node(glb, -1);
    text_print(&glb->nodes, "{\"name\":\"%s\",\"mesh\":%d", name, mesh);
    if (extras)
        text_print(&glb->nodes, ",\"extras\":%s", extras);
    text_append(&glb->nodes, "}", 1);
    return node;
}

/* --- textures --------------------------------------------------------------------------------- */

int glb_add_texture(struct glb *glb, int width, int height, const unsigned char *rgba,
                    const char *sampler) {
    struct text png = {0};
    png_append(&png, width, height, rgba);
    int view = add_view(glb, png.data, png.length, 0), begun = glb->texture_count, index = begun;
    free(png.data);
    next_element(&glb->images, &begun);
    text_print(&glb->images, "{\"bufferView\":%d,\"mimeType\":\"image/png\"}", view);
    begun = index;
    next_element(&glb->texture_samplers, &begun);
    text_print(&glb->texture_samplers, "{%s}", sampler);
    next_element(&glb->textures, &glb->texture_count);
    text_print(&glb->textures, "{\"source\":%d,\"sampler\":%d}", index, index);
    return index;
}

int glb_add_material_json(struct glb *glb, const char *json) {
    int index = next_element(&glb->materials, &glb->material_count);
    text_print(&glb->materials, "{%s}", json);
    return index;
}

int glb_add_textured_mesh(struct glb *glb, const char *name, const struct surface *surface,
                          const float (*uv)[2], int material) {
    char more[64];
    int coordinates = add_floats(glb, *uv, 2, surface->vertex_count, TARGET_VERTICES, NO_BOUNDS);
    snprintf(more, sizeof more, ",\"TEXCOORD_0\":%d", coordinates);
    int mesh = add_surface(glb, name, surface, material, more), node = next_node(glb, -1);
    text_print(&glb->nodes, "{\"name\":\"%s\",\"mesh\":%d}", name, mesh);
    return node;
}

/* --- motion ----------------------------------------------------------------------------------- */

int glb_add_joint(struct glb *glb, const char *name, int parent, const float translation[3]) {
    int node = next_node(glb, parent);
    text_print(&glb->nodes, "{\"name\":\"%s\",\"translation\":[%.9g,%.9g,%.9g]}", name,
               translation[0], translation[1], translation[2]);
    return node;
}

void glb_hang(struct glb *glb, int node, int parent) {
    glb->hierarchy[node].parent = parent;
}

static int add_skin(struct glb *glb, const char *name, const struct glb_skin *skin) {
    mat4 *inverse = mem_alloc((size_t)skin->joint_count, sizeof *inverse);
    for (int i = 0; i < skin->joint_count; i++) {
        vec3 back;
        glm_vec3_negate_to((float *)skin->rest[i], back);
        glm_translate_make(inverse[i], back);
    }
    int matrices = add_floats(glb, (float *)inverse, 16, (uint32_t)skin->joint_count, 0, NO_BOUNDS);
    free(inverse);
    int index = next_element(&glb->skins, &glb->skin_count);
    text_print(&glb->skins, "{\"name\":\"%s\",\"inverseBindMatrices\":%d,\"joints\":[", name,
               matrices);
    for (int i = 0; i < skin->joint_count; i++)
        text_print(&glb->skins, "%s%d", i ? "," : "", skin->joints[i]);
    text_print(&glb->skins, "]}");
    return index;
}

void glb_add_skinned_mesh(struct glb *glb, const char *name, const struct surface *surface,
                          int material, const struct glb_skin *skin) {
    uint32_t count = surface->vertex_count;
    int weights = add_floats(glb, *skin->vertex_weights, 4, count, TARGET_VERTICES, NO_BOUNDS);
    int view =
        add_view(glb, skin->vertex_joints, count * sizeof *skin->vertex_joints, TARGET_VERTICES);
    int joints = next_element(&glb->accessors, &glb->accessor_count);
    text_print(&glb->accessors,
               "{\"bufferView\":%d,\"componentType\":%d,\"count\":%u,\"type\":\"VEC4\"}", view,
               COMPONENT_UINT8, count);
    char more[80];
    snprintf(more, sizeof more, ",\"JOINTS_0\":%d,\"WEIGHTS_0\":%d", joints, weights);
    int mesh = add_surface(glb, name, surface, material, more);
    int index = add_skin(glb, name, skin);
    next_node(glb, -1);
    text_print(&glb->nodes, "{\"name\":\"%s\",\"mesh\":%d,\"skin\":%d}", name, mesh, index);
}

static void animate(struct glb *glb, int node, const char *path, int keys, const float *times,
                    const float *values, int width) {
    int input = add_floats(glb, times, 1, (uint32_t)keys, 0, BOUNDS);
    int output_index = add_floats(glb, values, width, (uint32_t)keys, 0, NO_BOUNDS);
    int sampler = next_element(&glb->samplers, &glb->sampler_count);
    text_print(&glb->samplers, "{\"input\":%d,\"output\":%d}", input, output_index);
    next_element(&glb->channels, &glb->channel_count);
    text_print(&glb->channels, "{\"sampler\":%d,\"target\":{\"node\":%d,\"path\":\"%s\"}}", sampler,
               node, path);
}

void glb_animate_translation(struct glb *glb, int node, int keys, const float *times,
                             const float (*values)[3]) {
    animate(glb, node, "translation", keys, times, *values, 3);
}

void glb_animate_rotation(struct glb *glb, int node, int keys, const float *times,
                          const float (*values)[4]) {
    animate(glb, node, "rotation", keys, times, *values, 4);
}

/* --- camera and lights ------------------------------------------------------------------------ */

void glb_direction(const float direction[3], float quaternion[4]) {
    vec3 back, right;
    mat3 turn;
    glm_vec3_scale((float *)direction, -1.0f, back);
    vec3_unit(back);
    /* Straight up or down, any right will do. */
    vec3 up = {0.0f, 1.0f, 0.0f};
    if (fabsf(back[1]) > 0.9999f)
        glm_vec3_copy((vec3){0.0f, 0.0f, 1.0f}, up);
    vec3_unit_cross(up, back, right);
    glm_vec3_copy(right, turn[0]);
    glm_vec3_cross(back, right, turn[1]);
    glm_vec3_copy(back, turn[2]);
    glm_mat3_quat(turn, quaternion);
}

/* A node at the eye that turns -Z into the direction; `what` is the rest of its JSON. */
static int add_placed_node(struct glb *glb, const char *name, const float eye[3],
                           const float direction[3], const char *what) {
    float q[4];
    glb_direction(direction, q);
    int node = next_node(glb, -1);
    text_print(&glb->nodes,
               "{\"name\":\"%s\",\"translation\":[%.9g,%.9g,%.9g],"
               "\"rotation\":[%.9g,%.9g,%.9g,%.9g],%s}",
               name, eye[0], eye[1], eye[2], q[0], q[1], q[2], q[3], what);
    return node;
}

int glb_add_camera(struct glb *glb, const float eye[3], const float direction[3], double fov,
                   double near, double far) {
    int camera = next_element(&glb->cameras, &glb->camera_count);
    text_print(&glb->cameras,
               "{\"name\":\"camera\",\"type\":\"perspective\",\"perspective\":{\"yfov\":%.9g,"
               "\"znear\":%.9g,\"zfar\":%.9g}}",
               fov * GLM_PI / 180.0, near, far);
    char what[32];
    snprintf(what, sizeof what, "\"camera\":%d", camera);
    return add_placed_node(glb, "camera", eye, direction, what);
}

static int add_light_node(struct glb *glb, const char *name, const float eye[3],
                          const float direction[3], int light) {
    char what[80];
    snprintf(what, sizeof what, "\"extensions\":{\"KHR_lights_punctual\":{\"light\":%d}}", light);
    return add_placed_node(glb, name, eye, direction, what);
}

int glb_add_light(struct glb *glb, const struct glb_light *light) {
    int index = next_element(&glb->lights, &glb->light_count);
    double outer = light->half_angle * GLM_PI / 180.0;
    text_print(&glb->lights,
               "{\"name\":\"%s\",\"type\":\"%s\",\"color\":[%.9g,%.9g,%.9g],\"intensity\":%.9g",
               light->name, outer > 0.0 ? "spot" : "point", light->color[0], light->color[1],
               light->color[2], light->intensity);
    if (outer > 0.0)
        text_print(&glb->lights, ",\"spot\":{\"innerConeAngle\":%.9g,\"outerConeAngle\":%.9g}",
                   outer - 0.005, outer);
    text_print(&glb->lights, "}");
    return add_light_node(glb, light->name, light->eye, light->direction, index);
}

int glb_add_spot(struct glb *glb, const float eye[3], const float direction[3], double half_angle,
                 double intensity) {
    struct glb_light light = {.name = "spot",
                              .color = {1.0f, 1.0f, 1.0f},
                              .half_angle = half_angle,
                              .intensity = intensity};
    glm_vec3_copy((float *)eye, light.eye);
    glm_vec3_copy((float *)direction, light.direction);
    return glb_add_light(glb, &light);
}

/* --- the file --------------------------------------------------------------------------------- */

static void append_array(struct text *json, const char *name, const struct text *elements) {
    text_print(json, ",\n\"%s\":[", name);
    text_append(json, elements->data, elements->length);
    text_append(json, "]", 1);
}

/* The nodes, each with those that hang on it. */
static void append_nodes(const struct glb *glb, struct text *json) {
    text_print(json, ",\n\"nodes\":[");
    for (int i = 0; i < glb->node_count; i++) {
        /* Up to the closing brace: ",\n" divides nodes. */
        size_t begin = glb->hierarchy[i].begin;
        size_t end = i + 1 < glb->node_count ? glb->hierarchy[i + 1].begin - 2 : glb->nodes.length;
        text_print(json, i ? ",\n" : "");
        text_append(json, glb->nodes.data + begin, end - begin - 1);
        int children = 0;
        for (int k = 0; k < glb->node_count; k++)
            if (glb->hierarchy[k].parent == i)
                text_print(json, children++ ? ",%d" : ",\"children\":[%d", k);
        text_print(json, children ? "]}" : "}");
    }
    text_append(json, "]", 1);
}

static void append_motion(const struct glb *glb, struct text *json) {
    if (glb->skin_count)
        append_array(json, "skins", &glb->skins);
    if (!glb->channel_count)
        return;
    text_print(json, ",\n\"animations\":[{\"name\":\"motion\"");
    append_array(json, "channels", &glb->channels);
    append_array(json, "samplers", &glb->samplers);
    text_print(json, "}]");
}

static void append_textures(const struct glb *glb, struct text *json) {
    if (!glb->texture_count)
        return;
    append_array(json, "images", &glb->images);
    append_array(json, "samplers", &glb->texture_samplers);
    append_array(json, "textures", &glb->textures);
}

static void compose_json(const struct glb *glb, struct text *json) {
    text_print(json,
               "{\"asset\":{\"version\":\"2.0\",\"generator\":\"manylight make_scenes\"},\n"
               "\"extensionsUsed\":[\"KHR_lights_punctual\"%s%s],\n"
               "\"extensions\":{\"KHR_lights_punctual\":{\"lights\":[",
               glb->has_lamps ? ",\"KHR_materials_emissive_strength\"" : "",
               glb->has_glass ? ",\"KHR_materials_transmission\",\"KHR_materials_ior\","
                                "\"KHR_materials_volume\""
                              : "");
    text_append(json, glb->lights.data, glb->lights.length);
    text_print(json, "]}},\n\"scene\":0,\"scenes\":[{\"name\":\"%s\",\"nodes\":[", glb->name);
    for (int i = 0, roots = 0; i < glb->node_count; i++)
        if (glb->hierarchy[i].parent < 0)
            text_print(json, "%s%d", roots++ ? "," : "", i);
    text_print(json, "]");
    if (glb->extras)
        text_print(json, ",\"extras\":{%s}", glb->extras);
    text_print(json, "}]");
    append_nodes(glb, json);
    append_array(json, "meshes", &glb->meshes);
    append_array(json, "materials", &glb->materials);
    append_textures(glb, json);
    append_array(json, "cameras", &glb->cameras);
    append_motion(glb, json);
    append_array(json, "accessors", &glb->accessors);
    append_array(json, "bufferViews", &glb->views);
    text_print(json, ",\n\"buffers\":[{\"byteLength\":%zu}]}", glb->binary.length);
    text_pad(json, ' ');
}

/* GLB is little endian, as are the machines this is built for. */
static void append_words(struct text *file, uint32_t a, uint32_t b) {
    text_append(file, &a, 4);
    text_append(file, &b, 4);
}

static void compose_file(const struct glb *glb, struct text *file) {
    struct text json = {0};
    compose_json(glb, &json);
    uint32_t total = (uint32_t)(12 + 8 + json.length + 8 + glb->binary.length);
    append_words(file, GLB_MAGIC, 2);
    text_append(file, &total, 4);
    append_words(file, (uint32_t)json.length, CHUNK_JSON);
    text_append(file, json.data, json.length);
    append_words(file, (uint32_t)glb->binary.length, CHUNK_BINARY);
    text_append(file, glb->binary.data, glb->binary.length);
    free(json.data);
}

static bool file_holds(const char *path, const struct text *text) {
    struct file_bytes bytes;
    bool same = file_read(&bytes, path) && bytes.size == text->length &&
                memcmp(bytes.data, text->data, bytes.size) == 0;
    free(bytes.data);
    return same;
}

bool glb_write(const struct glb *glb, const char *path) {
    struct text file = {0};
    compose_file(glb, &file);
    bool ok = file_holds(path, &file) || output_file_write(path, file.data, file.length);
    free(file.data);
    return ok;
}
