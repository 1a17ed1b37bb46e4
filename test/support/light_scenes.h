/* Scenes of glass and mirrors made by hand, and their pictures by light paths. */
#ifndef TEST_LIGHT_SCENES_H
#define TEST_LIGHT_SCENES_H

#include "hand_made.h"

#include "reference/light_tracer.h"

enum { MATERIAL_FLOOR, MATERIAL_SMOOTH, MATERIAL_INNER };

static inline void make_glass(struct material *material, float index) {
    *material = FILLED(material, .base_color = {1, 1, 1, 1}, .transmission = 1,
                       .index_of_refraction = index, .base_color_texture = -1,
                       .metal_roughness_texture = -1, .emission_texture = -1, .normal_texture = -1);
}

static inline void make_mirror(struct material *material, float reflectance) {
    make_glass(material, 1.5F);
    material->transmission = 0;
    material->metalness = 1;
    for (int c = 0; c < 3; c++)
        material->base_color[c] = reflectance;
}

/* The floor y = 0, that wide about the origin. */
static inline void add_floor(struct world *world, float size) {
    add_rectangle(world, MATERIAL_FLOOR, at(-size / 2, 0, size / 2), at(size, 0, 0),
                  at(0, 0, -size));
}

/* Seen from outside. */
static inline void add_box(struct world *world, int material, vec3s low, vec3s high) {
    vec3s size = glms_vec3_sub(high, low);
    vec3s x = at(size.x, 0, 0), y = at(0, size.y, 0), z = at(0, 0, size.z);
    add_rectangle(world, material, low, x, z);
    add_rectangle(world, material, low, y, x);
    add_rectangle(world, material, low, z, y);
    add_rectangle(world, material, high, glms_vec3_negate(z), glms_vec3_negate(x));
    add_rectangle(world, material, high, glms_vec3_negate(x), glms_vec3_negate(y));
    add_rectangle(world, material, high, glms_vec3_negate(y), glms_vec3_negate(z));
}

/* add_sphere's inside out, so large and there. */
static inline void add_ball(struct world *world, int material, int rings, vec3s center,
                            float radius) {
    struct geometry *geometry = &world->geometry;
    uint32_t vertex = geometry->vertex_count, index = geometry->index_count;
    add_sphere(world, material, rings);
    for (uint32_t i = vertex; i < geometry->vertex_count; i++)
        for (int c = 0; c < 3; c++) {
            geometry->position[i][c] = center.raw[c] + radius * geometry->position[i][c];
            geometry->normal[i][c] *= -1;
        }
    for (uint32_t i = index; i < geometry->index_count; i += 3) {
        uint32_t other = geometry->indices[i + 1];
        geometry->indices[i + 1] = geometry->indices[i + 2];
        geometry->indices[i + 2] = other;
    }
}

/* The bounds of all scenes that are compared, so that a medium fills the same ball. */
static inline void finish(struct world *world, float radius) {
    world_finish(world);
    world->geometry.radius = radius;
    memset(world->geometry.center, 0, sizeof world->geometry.center);
}

/* --- pictures --------------------------------------------------------------------------------- */

struct look {
    int size, samples, paths, threads;
    bool straight;
    uint32_t seed;
    struct medium medium;
};

/* The path tracer's picture, and what light paths add. */
static inline struct light_tracer_result trace(struct world *world, const struct emitters *lights,
                                               const struct look *look, struct image *image) {
    struct path_tracer_desc desc = describe(world, look->size, look->samples);
    struct light_tracer_result result;
    desc.smooth = true;
    desc.medium = look->medium;
    if (lights)
        desc.emitters = *lights;
    render(&desc, image);
    check_ok("light paths",
             light_tracer_render(
                 &FILLED(light_tracer_desc, .scene = &world->scene, .geometry = &world->geometry,
                         .camera = &world->camera, .emitters = desc.emitters, .width = look->size,
                         .height = look->size, .paths = look->paths, .medium = look->medium,
                         .seed = look->seed, .straight = look->straight, .threads = look->threads),
                 image, &result));
    return result;
}

static inline double mean_of_layer(const struct image *image, const char *layer) {
    int channels[3];
    assert_true(image_find_layer(image, layer, channels));
    return image_mean(image, channels);
}

/* Of a layer of irradiance what surfaces reflect: pixels count by what of them is covered. */
static inline double reflected(const struct image *image, const char *layer) {
    int channels[3];
    double sum = 0;
    assert_true(image_find_layer(image, layer, channels));
    for (int i = 0; i < image->width * image->height; i++) {
        const float *pixel = image_at(image, i % image->width, i / image->width);
        for (int c = 0; c < 3; c++)
            sum += (double)(pixel[channels[c]] * pixel[CHANNEL_ALBEDO + c]);
    }
    return sum;
}

static inline void check_finite(const struct image *image) {
    size_t count = (size_t)image->width * (size_t)image->height * (size_t)image->channel_count;
    for (size_t i = 0; i < count; i++)
        assert_true(isfinite(image->pixels[i]));
}

/* All flux is accounted for. */
static inline void check_balance(const struct light_balance *balance) {
    double sum =
        balance->missed + balance->landed + balance->absorbed + balance->escaped + balance->cut;
    printf("    emitted %.6g W: missed %.4g, landed %.4g, absorbed %.4g, escaped %.4g, cut %.4g\n",
           balance->emitted, balance->missed, balance->landed, balance->absorbed, balance->escaped,
           balance->cut);
    check_near("accounted for", sum / balance->emitted, 1, 1e-6);
}

#endif
