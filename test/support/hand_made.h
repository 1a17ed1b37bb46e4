/* Scenes made by hand for the tests of the reference floor: rectangles and spheres. */
#ifndef TEST_HAND_MADE_H
#define TEST_HAND_MADE_H

#include "base/unit.h"
#include "support.h"

#include "reference/channels.h"
#include "reference/path_tracer.h"
#include "scene/material.h"

enum { MAX_VERTICES = 20000, MAX_MATERIALS = 4 };

/* One batch per call of an add function; masked materials and panes must be added last. */
struct world {
    struct scene scene;
    struct material materials[MAX_MATERIALS];
    struct geometry geometry;
    struct geometry_batch batches[8];
    struct camera camera;
    struct emitter light;
};

static inline vec3s at(float x, float y, float z) {
    return (vec3s){{x, y, z}};
}

static inline void world_init(struct world *world) {
    struct geometry *geometry = &world->geometry;
    memset(world, 0, sizeof *world);
    for (int m = 0; m < MAX_MATERIALS; m++)
        world->materials[m] = FILLED(
            material, .base_color = {0.5f, 0.5f, 0.5f, 1}, .roughness = 1,
            .specular_f0 = {DIELECTRIC_F0, DIELECTRIC_F0, DIELECTRIC_F0}, .specular_f90 = 1,
            .index_of_refraction = 1.5f, .base_color_texture = -1, .metal_roughness_texture = -1,
            .emission_texture = -1, .normal_texture = -1, .alpha_cutoff = 0.5f);
    world->scene.materials = world->materials;
    geometry->position = mem_alloc(MAX_VERTICES + 1, sizeof *geometry->position);
    geometry->normal = mem_alloc(MAX_VERTICES, sizeof *geometry->normal);
    geometry->uv[0] = mem_alloc(MAX_VERTICES, sizeof *geometry->uv[0]);
    geometry->mapping_count = 1;
    geometry->color = mem_alloc(MAX_VERTICES, sizeof *geometry->color);
    geometry->indices = mem_alloc(6 * MAX_VERTICES, sizeof *geometry->indices);
    geometry->batches = world->batches;
    world->camera.forward[2] = -1;
}

static inline void world_free(struct world *world) {
    free(world->geometry.position);
    free(world->geometry.normal);
    for (int m = 0; m < MAPPINGS_MAX; m++)
        free(world->geometry.uv[m]);
    free(world->geometry.color);
    free(world->geometry.indices);
    *world = (struct world){0};
}

static inline uint32_t add_vertex(struct world *world, vec3s position, vec3s normal, float u,
                                  float v) {
    struct geometry *geometry = &world->geometry;
    uint32_t i = geometry->vertex_count++;
    assert_true(i < MAX_VERTICES);
    memcpy(geometry->position[i], position.raw, sizeof position.raw);
    memcpy(geometry->normal[i], normal.raw, sizeof normal.raw);
    geometry->uv[0][i][0] = u;
    geometry->uv[0][i][1] = v;
    for (int c = 0; c < 4; c++)
        geometry->color[i][c] = 1;
    return i;
}

static inline void add_square(struct world *world, uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
    uint32_t *to = &world->geometry.indices[world->geometry.index_count];
    memcpy(to, (uint32_t[]){a, b, c, a, c, d}, 6 * sizeof *to);
    world->geometry.index_count += 6;
}

static inline void end_batch(struct world *world, int material, uint32_t first_index) {
    struct geometry *geometry = &world->geometry;
    geometry->batches[geometry->batch_count++] =
        (struct geometry_batch){.material = material,
                                .first_index = first_index,
                                .index_count = geometry->index_count - first_index};
    if (!world->materials[material].alpha_mask && !material_lets_pass(&world->materials[material]))
        geometry->opaque_index_count = geometry->index_count;
}

/* Counter-clockwise around u x v, which is its normal. */
static inline void add_rectangle(struct world *world, int material, vec3s corner, vec3s u,
                                 vec3s v) {
    vec3s normal = vec3s_unit_cross(u, v);
    uint32_t first = world->geometry.index_count;
    uint32_t a = add_vertex(world, corner, normal, 0, 0);
    uint32_t b = add_vertex(world, glms_vec3_add(corner, u), normal, 1, 0);
    uint32_t c = add_vertex(world, glms_vec3_add(corner, glms_vec3_add(u, v)), normal, 1, 1);
    uint32_t d = add_vertex(world, glms_vec3_add(corner, v), normal, 0, 1);
    add_square(world, a, b, c, d);
    end_batch(world, material, first);
}

/* The inside of the unit sphere, with smooth normals. */
static inline void add_sphere(struct world *world, int material, int rings) {
    uint32_t first = world->geometry.index_count, start = world->geometry.vertex_count;
    uint32_t sides = 2 * (uint32_t)rings;
    for (int j = 0; j <= rings; j++)
        for (uint32_t i = 0; i <= sides; i++) {
            double theta = GLM_PI * j / rings, phi = 2 * GLM_PI * i / sides;
            vec3s p = {{(float)(sin(theta) * cos(phi)), (float)cos(theta),
                        (float)(sin(theta) * sin(phi))}};
            add_vertex(world, p, glms_vec3_negate(p), 0, 0);
        }
    for (uint32_t j = 0; j < (uint32_t)rings; j++)
        for (uint32_t i = 0; i < sides; i++) {
            uint32_t a = start + j * (sides + 1) + i, below = a + sides + 1;
            add_square(world, a, below, below + 1, a + 1);
        }
    end_batch(world, material, first);
}

/* The bounding sphere of the bounding box. */
static inline void world_finish(struct world *world) {
    struct geometry *geometry = &world->geometry;
    vec3s low = glms_vec3_scale(glms_vec3_one(), INFINITY), high = glms_vec3_negate(low);
    for (uint32_t i = 0; i < geometry->vertex_count; i++)
        for (int c = 0; c < 3; c++) {
            low.raw[c] = fminf(low.raw[c], geometry->position[i][c]);
            high.raw[c] = fmaxf(high.raw[c], geometry->position[i][c]);
        }
    geometry->radius = glms_vec3_distance(low, high) / 2;
    memcpy(geometry->bounds_min, low.raw, sizeof low.raw);
    memcpy(geometry->bounds_max, high.raw, sizeof high.raw);
    memcpy(geometry->center, glms_vec3_center(low, high).raw, sizeof low.raw);
}

/* Orthographic, straight down on the square [x0, x0 + size] x [z0, z0 + size] of the floor. */
static inline void look_down(struct world *world, float x0, float z0, float size, float height) {
    world->camera =
        FILLED(camera, .orthographic = true, .eye = {x0 + size / 2, height, z0 + size / 2},
               .right = {1, 0, 0}, .up = {0, 0, -1}, .forward = {0, -1, 0}, .y_extent = size / 2);
}

static inline void place_light(struct world *world, enum emitter_type type, vec3s position,
                               vec3s direction, float intensity) {
    struct emitter *light = &world->light;
    *light = FILLED(emitter, .type = type, .intensity = {intensity, intensity, intensity},
                    .cos_inner = -1, .cos_outer = -1);
    memcpy(light->position, position.raw, sizeof position.raw);
    memcpy(light->direction, vec3s_unit(direction).raw, sizeof direction.raw);
}

/* A camera within the unit sphere of albedo 1/2, off its centre, where a point light of pi W/sr is:
 * direct light is 1 everywhere, and one bounce 1/2. */
static inline void world_in_sphere(struct world *world) {
    world_init(world);
    add_sphere(world, 0, 64);
    world_finish(world);
    world->camera = FILLED(camera, .eye = {0.2f, 0.1f, 0.6f}, .right = {1, 0, 0}, .up = {0, 1, 0},
                           .forward = {0, 0, -1}, .fov_y = 1.4f);
    place_light(world, EMITTER_POINT, glms_vec3_zero(), (vec3s){{0, 0, -1}}, GLM_PIf);
}

static inline struct path_tracer_desc describe(struct world *world, int size, int samples) {
    return FILLED(path_tracer_desc, .scene = &world->scene, .geometry = &world->geometry,
                  .camera = &world->camera, .emitters = {.items = &world->light, .count = 1},
                  .width = size, .height = size, .samples = samples);
}

static inline struct path_tracer_progress render(const struct path_tracer_desc *desc,
                                                 struct image *image) {
    struct path_tracer_progress reached;
    check_ok("render", path_tracer_render(desc, image, &reached));
    return reached;
}

/* The mean of one channel over all pixels. */
static inline double mean_of(const struct image *image, int channel) {
    double sum = 0;
    for (int y = 0; y < image->height; y++)
        for (int x = 0; x < image->width; x++)
            sum += image_at(image, x, y)[channel];
    return sum / image->width / image->height;
}

/* RMS over pixels of channel minus value, over value. */
static inline double spread_about(const struct image *image, int channel, double value) {
    double sum = 0;
    for (int y = 0; y < image->height; y++)
        for (int x = 0; x < image->width; x++)
            sum += pow(image_at(image, x, y)[channel] - value, 2);
    return sqrt(sum / image->width / image->height) / value;
}

#endif
