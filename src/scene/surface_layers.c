#define _POSIX_C_SOURCE 200809L
#include "scene/surface_layers.h"

#include "base/json.h"
#include "base/memory.h"
#include "scene/cryptomatte.h"

#include <cglm/cglm.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { NODE, MESH, MATERIAL, POSITION, DEPTH, UV, NEXT, PREVIOUS, MATTES, LAYERS = MATTES + 3 };

const char *const surface_layer_names[] = {
    "id.node",     "id.mesh",         "id.material", "position",    "depth",           "uv",
    "motion.next", "motion.previous", "crypto.node", "crypto.mesh", "crypto.material", NULL};

/* Two ranks per layer, id and coverage each. Small letters keep them floats in EXR. Blender 3 needs
 * layer names without dots. */
#define RANKS(name) name ".r " name ".g " name ".b " name ".a"
#define MATTE(name) RANKS(name "00") " " RANKS(name "01") " " RANKS(name "02")

static const char *const channels[LAYERS] = {"id.node",
                                             "id.mesh",
                                             "id.material",
                                             "position.X position.Y position.Z",
                                             "depth",
                                             "uv.U uv.V",
                                             "motion.next.X motion.next.Y",
                                             "motion.previous.X motion.previous.Y",
                                             MATTE("crypto_node"),
                                             MATTE("crypto_mesh"),
                                             MATTE("crypto_material")};

static const char *const attributes[] = {"manylight:id.node", "manylight:id.mesh",
                                         "manylight:id.material"};

int surface_layer_find(const char *name) {
    for (int i = 0; i < LAYERS; i++)
        if (strcmp(surface_layer_names[i], name) == 0)
            return i;
    return -1;
}

uint32_t *surface_layer_numbers(const struct surface_view *view, int layer) {
    const struct geometry *geometry = view->geometry;
    uint32_t *ids = mem_alloc(geometry->index_count / 3, sizeof *ids);
    for (int i = 0; layer == MATERIAL && i < geometry->batch_count; i++) {
        const struct geometry_batch *batch = &geometry->batches[i];
        for (uint32_t n = 0; n < batch->index_count / 3; n++)
            ids[batch->first_index / 3 + n] = (uint32_t)batch->material + 1;
    }
    for (int i = 0; layer != MATERIAL && i < geometry->part_count; i++) {
        const struct geometry_part *part = &geometry->parts[i];
        int id = layer == NODE ? part->node : view->scene->nodes[part->node].mesh;
        for (uint32_t n = 0; n < part->index_room / 3; n++)
            ids[part->first_index / 3 + n] = (uint32_t)(id + 1);
    }
    return ids;
}

static int count_of(const struct scene *scene, int layer) {
    return layer == NODE   ? scene->node_count
           : layer == MESH ? scene->mesh_count
                           : scene->material_count;
}

const char *surface_layer_id_name(const struct scene *scene, int layer, int i) {
    if (layer < NODE || layer > MATERIAL || i < 0 || i >= count_of(scene, layer))
        return NULL;
    return layer == NODE   ? scene->nodes[i].name
           : layer == MESH ? scene->meshes[i].name
                           : scene->materials[i].name;
}

static void add_names(const struct surface_view *view, int layer, const bool *seen,
                      struct image *image) {
    char *text = NULL, key[16];
    size_t size = 0;
    struct json json = {.out = open_memstream(&text, &size)};
    json_open(&json, NULL, "{");
    for (int i = 0; i < count_of(view->scene, layer); i++) {
        snprintf(key, sizeof key, "%d", i + 1);
        if (seen[i + 1])
            json_text(&json, key, surface_layer_id_name(view->scene, layer, i));
    }
    json_close(&json, "}");
    if (json.out && fclose(json.out) == 0)
        image_add_text(image, attributes[layer], text);
    free(text);
}

static void fill_ids(const struct surface_view *view, int layer, int channel, struct image *image) {
    uint32_t *ids = surface_layer_numbers(view, layer);
    bool *seen = mem_alloc((size_t)count_of(view->scene, layer) + 1, sizeof *seen);
    size_t pixels = (size_t)image->width * (size_t)image->height;
    for (size_t i = 0; i < pixels; i++) {
        uint32_t id = view->triangles[i] ? ids[view->triangles[i] - 1] : 0;
        image->pixels[i * (size_t)image->channel_count + (size_t)channel] = (float)id;
        seen[id] = true;
    }
    add_names(view, layer, seen, image);
    mem_free(ids, seen);
}

/* Moves the weights of a point outside a triangle to the nearest point of an edge, as seen along
 * the direction. */
static void move_inside(const float *const corners[3], const float direction[3],
                        double weights[3]) {
    for (int i = 0; i < 3; i++) {
        int a = (i + 1) % 3, b = (i + 2) % 3;
        vec3 edge, other;
        if (weights[i] >= 0)
            continue;
        glm_vec3_sub((float *)corners[b], (float *)corners[a], edge);
        glm_vec3_sub((float *)corners[i], (float *)corners[a], other);
        glm_vec3_muladds((float *)direction, -glm_vec3_dot(edge, (float *)direction), edge);
        double along = (double)glm_vec3_dot(other, edge), length = (double)glm_vec3_norm2(edge);
        weights[b] = fmin(fmax(weights[b] + weights[i] * along / length, 0), 1);
        weights[a] = 1 - weights[b];
        weights[i] = 0;
    }
}

/* Writes the weights of a triangle's corners where a ray meets its plane, in the triangle: its edge
 * may pass the centre of the pixel by rounding. */
static void weigh_corners(float (*positions)[3], const uint32_t index[3], const float origin[3],
                          const float direction[3], double weights[3]) {
    const float *corners[3] = {positions[index[0]], positions[index[1]], positions[index[2]]};
    double edges[2][3], from[3], p[3], q[3], u = 0, v = 0, det = 0;
    for (int c = 0; c < 3; c++) {
        edges[0][c] = (double)corners[1][c] - (double)corners[0][c];
        edges[1][c] = (double)corners[2][c] - (double)corners[0][c];
        from[c] = (double)origin[c] - (double)corners[0][c];
    }
    for (int c = 0; c < 3; c++) {
        int a = (c + 1) % 3, b = (c + 2) % 3;
        p[c] = (double)direction[a] * edges[1][b] - (double)direction[b] * edges[1][a];
        q[c] = from[a] * edges[0][b] - from[b] * edges[0][a];
    }
    for (int c = 0; c < 3; c++) {
        det += edges[0][c] * p[c];
        u += from[c] * p[c];
        v += (double)direction[c] * q[c];
    }
    weights[1] = det == 0 ? 1 / 3. : u / det;
    weights[2] = det == 0 ? 1 / 3. : v / det;
    weights[0] = 1 - weights[1] - weights[2];
    move_inside(corners, direction, weights);
}

void surface_motion_free(struct surface_motion *motion) {
    mem_free(motion->positions[0], motion->positions[1]);
    *motion = (struct surface_motion){.positions = {NULL}};
}

bool surface_layers_move(const char *names) {
    return names && strstr(names, "motion.");
}

/* Returns the point of three vertices with these weights. */
static void mix(float (*positions)[3], const uint32_t index[3], const double weights[3],
                float point[3]) {
    for (int c = 0; c < 3; c++) {
        double sum = 0;
        for (int i = 0; i < 3; i++)
            sum += weights[i] * (double)positions[index[i]][c];
        point[c] = (float)sum;
    }
}

/* Writes the pixels from a point to its place in another frame: 0 the next. */
static void fill_motion(const struct surface_view *view, int frame, const float now[3],
                        const float then[3], const int size[2], float out[2]) {
    struct camera other = view->motion->cameras[frame];
    float places[2][2], aspect = (float)size[0] / (float)size[1];
    other.lens = view->camera->lens;
    other.skew = view->camera->skew;
    memcpy(other.distortion, view->camera->distortion, sizeof other.distortion);
    if (!camera_project(view->camera, now, aspect, places[0]) ||
        !camera_project(&other, then, aspect, places[1]))
        return;
    for (int axis = 0; axis < 2; axis++)
        out[axis] = (places[1][axis] - places[0][axis]) * (float)size[axis];
    if (other.lens == LENS_EQUIRECTANGULAR) /* the way past the seam is shorter */
        out[0] -= (float)size[0] * roundf(places[1][0] - places[0][0]);
}

static void fill_point(const struct surface_view *view, int layer, int x, int y, const int size[2],
                       float *out) {
    const struct geometry *geometry = view->geometry;
    uint32_t triangle = view->triangles[(size_t)y * (size_t)size[0] + (size_t)x];
    float origin[3], direction[3], point[3], other[3];
    float width = (float)size[0], height = (float)size[1];
    double weights[3];
    if (triangle == 0)
        return;
    const uint32_t *index = geometry->indices + 3 * (size_t)(triangle - 1);
    camera_ray(view->camera, ((float)x + .5F) / width, ((float)y + .5F) / height, width / height,
               origin, direction);
    weigh_corners(geometry->position, index, origin, direction, weights);
    mix(geometry->position, index, weights, point);
    switch (layer) {
    case UV:
        for (int i = 0; i < 6; i++)
            out[i % 2] += (float)weights[i / 2] * geometry->uv[0][index[i / 2]][i % 2];
        return;
    case DEPTH:
        glm_vec3_sub(point, origin, other);
        *out = glm_vec3_dot(other, direction);
        return;
    case POSITION:
        memcpy(out, point, sizeof point);
        return;
    default:
        mix(view->motion->positions[layer - NEXT], index, weights, other);
        fill_motion(view, layer - NEXT, point, other, size, out);
    }
}

bool surface_layer_is_matte(const char *name) {
    return surface_layer_find(name) >= MATTES;
}

static void append(const struct surface_view *view, int layer, struct image *image) {
    char first[32];
    int channel = image->channel_count;
    snprintf(first, sizeof first, "%.*s", (int)strcspn(channels[layer], " "), channels[layer]);
    if (image_find_channel(image, first) >= 0)
        return;
    image_add_channels(image, channels[layer]);
    if (layer <= MATERIAL)
        fill_ids(view, layer, channel, image);
    for (int y = 0; MATERIAL < layer && layer < MATTES && y < image->height; y++)
        for (int x = 0; x < image->width; x++)
            fill_point(view, layer, x, y, (int[]){image->width, image->height},
                       image_at(image, x, y) + channel);
}

bool surface_layers_append(const struct surface_view *view, const char *names,
                           struct image *image) {
    char *list = mem_strdup(names), *next = NULL;
    for (char *name = strtok_r(list, ",", &next); name; name = strtok_r(NULL, ",", &next))
        if (surface_layer_find(name) >= 0)
            append(view, surface_layer_find(name), image);
    mem_free(list);
    return cryptomatte_fill(view, image);
}
