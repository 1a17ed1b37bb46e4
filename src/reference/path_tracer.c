#include "reference/path_tracer.h"

#include "reference/film.h"
#include "reference/layers.h"
#include "reference/path.h"

#include "base/error.h"
#include "base/memory.h"
#include "base/parallel.h"

#include <assert.h>
#include <math.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>

enum { FIRST_PASS_POINTS = 8 };

/* Indirect paths from each point that the camera sees: the noise is in them, not in the camera ray
 * and the direct light, whose rays are thus shared. */
enum { PATHS_PER_SAMPLE = 4 };

struct renderer {
    struct path_tracer_desc desc; /* resolved */
    struct ray_scene rays;
    struct emitter emitter;
    struct film_pixel *pixels;
    uint32_t done, end;   /* points of each stream: of earlier passes, and after the present one */
    double noise;         /* after the last pass */
    atomic_int rows_done; /* in the present pass */
    atomic_bool cancelled;
    pthread_mutex_t progress_lock;
};

/* --- samples --- */

static vec3s vector(const float v[3]) {
    return (vec3s){{v[0], v[1], v[2]}};
}

static struct film_pixel *pixel_at(const struct renderer *renderer, int x, int y) {
    return &renderer->pixels[(size_t)y * (size_t)renderer->desc.width + (size_t)x];
}

/* What the camera sees at a point of the picture, in pixels. */
static bool look(const struct renderer *renderer, float x, float y, struct hit *hit) {
    const struct path_tracer_desc *desc = &renderer->desc;
    float width = (float)desc->width, height = (float)desc->height, origin[3], direction[3];
    camera_ray(desc->camera, x / width, y / height, width / height, origin, direction);
    return ray_scene_camera_hit(&renderer->rays, vector(origin), vector(direction), hit);
}

static vec3s mean_of_paths(const struct renderer *renderer, const struct hit *hit, uint32_t seed,
                           uint32_t index) {
    vec3s sum = glms_vec3_zero();
    for (uint32_t i = 0; i < PATHS_PER_SAMPLE; i++) {
        struct sampler sampler = {.seed = seed, .index = index * PATHS_PER_SAMPLE + i, .pair = 1};
        sum = glms_vec3_add(sum, path_indirect(&renderer->rays, &renderer->emitter,
                                               renderer->desc.bounces, hit, &sampler));
    }
    return glms_vec3_scale(sum, 1.0f / PATHS_PER_SAMPLE);
}

/* What the sample of that index of a stream sees; false where that is nothing. */
static bool take_sample(const struct renderer *renderer, int px, int py, uint32_t seed,
                        uint32_t index, struct film_sample *sample) {
    struct hit hit;
    vec2s jitter = sampler_next(&(struct sampler){.seed = seed, .index = index});
    if (!look(renderer, (float)px + jitter.x, (float)py + jitter.y, &hit))
        return false;
    *sample = (struct film_sample){
        .albedo = hit.albedo,
        .normal = hit.normal,
        .direct = emitter_direct(&renderer->emitter, &renderer->rays, &hit),
        .indirect = mean_of_paths(renderer, &hit, seed, index),
    };
    return true;
}

/* Sums of a pass are made apart, so that a long render loses no digits. */
static void add_pass(const struct renderer *renderer, int px, int py) {
    uint32_t pixel_number = (uint32_t)py * (uint32_t)renderer->desc.width + (uint32_t)px;
    uint32_t pixel_seed = sampler_hash(renderer->desc.seed, pixel_number);
    struct film_pixel sums = {0};
    struct film_sample sample;
    for (int stream = 0; stream < FILM_STREAMS; stream++) {
        uint32_t seed = sampler_hash(pixel_seed, (uint32_t)stream);
        for (uint32_t i = renderer->done; i < renderer->end; i++)
            if (take_sample(renderer, px, py, seed, i, &sample))
                film_pixel_add(&sums, stream, &sample);
    }
    film_pixel_merge(pixel_at(renderer, px, py), &sums);
}

/* --- passes --- */

/* With these low-dimensional integrands the error falls about as points^-0.75. */
static double points_needed(const struct renderer *renderer) {
    const struct path_tracer_desc *desc = &renderer->desc;
    if (desc->samples > 0)
        return ceil(desc->samples / (double)FILM_STREAMS);
    return renderer->done * pow(renderer->noise / desc->noise, 1 / 0.75);
}

static void report(struct renderer *renderer) {
    const struct path_tracer_desc *desc = &renderer->desc;
    if (!desc->progress)
        return;
    double in_pass = (double)atomic_load(&renderer->rows_done) / desc->height;
    double points = renderer->done + (renderer->end - renderer->done) * in_pass;
    struct path_tracer_progress progress = {
        .done = points / fmax(points_needed(renderer), renderer->end),
        .noise = renderer->noise,
        .samples = (int)renderer->done * FILM_STREAMS,
    };
    pthread_mutex_lock(&renderer->progress_lock);
    if (!desc->progress(desc->user, &progress))
        atomic_store(&renderer->cancelled, true);
    pthread_mutex_unlock(&renderer->progress_lock);
}

static void render_row(void *context, size_t row) {
    struct renderer *renderer = context;
    for (int x = 0; x < renderer->desc.width && !atomic_load(&renderer->cancelled); x++)
        add_pass(renderer, x, (int)row);
    atomic_fetch_add(&renderer->rows_done, 1);
    report(renderer);
}

/* Standard error, RMS over pixels and channels, over the mean. */
static double estimate_noise(const struct renderer *renderer) {
    size_t pixel_count = (size_t)renderer->desc.width * (size_t)renderer->desc.height;
    double mean_sum = 0, variance_sum = 0;
    for (size_t i = 0; i < pixel_count; i++) {
        struct film_estimate estimate = film_pixel_estimate(&renderer->pixels[i]);
        for (int c = 0; c < 3; c++) {
            mean_sum += estimate.mean[c];
            variance_sum += estimate.variance[c];
        }
    }
    double values = 3 * (double)pixel_count;
    return mean_sum > 0 ? sqrt(variance_sum / values) / (mean_sum / values) : 0;
}

static bool render_pass(struct renderer *renderer, uint32_t end) {
    renderer->end = end;
    atomic_store(&renderer->rows_done, 0);
    parallel_for((size_t)renderer->desc.height, renderer->desc.threads, render_row, renderer);
    if (atomic_load(&renderer->cancelled))
        return error_set("cancelled");
    renderer->done = end;
    renderer->noise = estimate_noise(renderer);
    return true;
}

/* Low-discrepancy points are best by powers of two; of the counts between, midway is good too. */
static uint32_t next_end(uint32_t done) {
    bool is_power_of_two = (done & (done - 1)) == 0;
    return is_power_of_two ? done + done / 2 : done / 3 * 4;
}

static bool render_passes(struct renderer *renderer) {
    if (renderer->desc.samples > 0)
        return render_pass(renderer, (uint32_t)points_needed(renderer));
    bool ok = render_pass(renderer, FIRST_PASS_POINTS);
    while (ok && renderer->noise > renderer->desc.noise)
        ok = render_pass(renderer, next_end(renderer->done));
    return ok;
}

/* --- the picture --- */

struct picture {
    const struct renderer *renderer;
    struct image *image;
};

static float depth_at(const struct renderer *renderer, int px, int py) {
    const struct camera *camera = renderer->desc.camera;
    struct hit hit;
    if (!look(renderer, (float)px + 0.5f, (float)py + 0.5f, &hit))
        return 0;
    return glms_vec3_dot(glms_vec3_sub(hit.position, vector(camera->eye)), vector(camera->forward));
}

static void develop_row(void *context, size_t row) {
    const struct picture *picture = context;
    const struct renderer *renderer = picture->renderer;
    for (int x = 0, y = (int)row; x < renderer->desc.width; x++) {
        float *layers = image_at(picture->image, x, y);
        film_pixel_develop(pixel_at(renderer, x, y), (int)renderer->done * FILM_STREAMS, layers);
        layers[LAYER_DEPTH] = depth_at(renderer, x, y);
    }
}

static void develop(const struct renderer *renderer, struct image *image) {
    const struct path_tracer_desc *desc = &renderer->desc;
    struct picture picture = {renderer, image};
    image_init(image, desc->width, desc->height, LAYERS_OF_PATH_TRACER);
    parallel_for((size_t)desc->height, desc->threads, develop_row, &picture);
}

static struct path_tracer_desc resolve(const struct path_tracer_desc *desc) {
    struct path_tracer_desc resolved = *desc;
    assert(desc->scene && desc->geometry && desc->camera && desc->light && desc->bounces >= 0);
    if (resolved.width == 0)
        resolved.width = 800;
    if (resolved.height == 0)
        resolved.height = 800;
    if (resolved.noise == 0)
        resolved.noise = 0.01;
    return resolved;
}

bool path_tracer_render(const struct path_tracer_desc *desc, struct image *image,
                        struct path_tracer_progress *reached) {
    struct renderer renderer = {.desc = resolve(desc),
                                .emitter = emitter_of(desc->light, desc->geometry)};
    size_t pixel_count = (size_t)renderer.desc.width * (size_t)renderer.desc.height;
    struct hit_table table;
    *image = (struct image){0};
    hit_table_init(&table, desc->scene, desc->geometry);
    renderer.pixels = mem_alloc(pixel_count, sizeof *renderer.pixels);
    pthread_mutex_init(&renderer.progress_lock, NULL);
    bool ok = ray_scene_init(&renderer.rays, &table) && render_passes(&renderer);
    if (ok)
        develop(&renderer, image);
    if (ok && reached)
        *reached =
            (struct path_tracer_progress){1, renderer.noise, (int)renderer.done * FILM_STREAMS};
    pthread_mutex_destroy(&renderer.progress_lock);
    free(renderer.pixels);
    ray_scene_free(&renderer.rays);
    hit_table_free(&table);
    return ok;
}
