#include "reference/path_tracer.h"

#include "reference/path.h"

#include "base/error.h"
#include "base/memory.h"
#include "base/parallel.h"

#include <assert.h>
#include <math.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>

/* Independent streams of low-discrepancy points. Points of one stream repel each other, so only
 * the spread between streams tells the error: more streams make a surer estimate of it, longer ones
 * a smaller error. */
enum {
    STREAMS = PATH_TRACER_STREAMS,
    PILOT_POINTS = 4,
    FIRST_PASS_POINTS = 8,
    LAYER_STANDARD_ERROR = LAYER_COUNT
};

/* Indirect paths from each point that the camera sees: the noise is in them, not in the camera ray
 * and the direct light, whose rays are thus shared. */
enum { PATHS_PER_SAMPLE = 4 };

struct renderer {
    struct path_tracer_desc desc; /* resolved */
    struct ray_scene rays;
    struct emitter emitter;
    struct image *image;           /* sums, until finish_pixel */
    float (*indirect)[STREAMS][3]; /* sums of each pixel's streams */
    uint32_t done, end;   /* points of each stream: of earlier passes, and after the present one */
    double noise;         /* after the last pass */
    atomic_int rows_done; /* in the present pass */
    atomic_bool cancelled;
    pthread_mutex_t progress_lock;
};

/* --- samples ------------------------------------------------------------------------------------
 */

static vec3s vector(const float v[3]) {
    return (vec3s){{v[0], v[1], v[2]}};
}

static size_t pixel_number(const struct renderer *renderer, int x, int y) {
    return (size_t)y * (size_t)renderer->desc.width + (size_t)x;
}

/* What the camera sees at a point of the picture, in pixels. */
static bool look(const struct renderer *renderer, float x, float y, struct hit *hit) {
    const struct path_tracer_desc *desc = &renderer->desc;
    float width = (float)desc->width, height = (float)desc->height, origin[3], direction[3];
    camera_ray(desc->camera, x / width, y / height, width / height, origin, direction);
    return ray_scene_camera_hit(&renderer->rays, vector(origin), vector(direction), hit);
}

static void add(float *sum, vec3s value) {
    for (int c = 0; c < 3; c++)
        sum[c] += value.raw[c];
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

/* The sample of that index of a stream, added to the layers and to the stream's indirect light. */
static void add_sample(const struct renderer *renderer, int px, int py, uint32_t seed,
                       uint32_t index, float *layers, float *indirect) {
    struct hit hit;
    vec2s jitter = sampler_next(&(struct sampler){.seed = seed, .index = index});
    if (!look(renderer, (float)px + jitter.x, (float)py + jitter.y, &hit))
        return;
    vec3s direct = emitter_direct(&renderer->emitter, &renderer->rays, &hit);
    vec3s bounced = mean_of_paths(renderer, &hit, seed, index);
    add(&layers[LAYER_BEAUTY], glms_vec3_mul(hit.albedo, glms_vec3_add(direct, bounced)));
    layers[LAYER_ALPHA] += 1;
    add(&layers[LAYER_DIRECT], direct);
    add(&layers[LAYER_ALBEDO], hit.albedo);
    add(&layers[LAYER_NORMAL], hit.normal);
    add(indirect, bounced);
}

/* Sums of a pass are made apart, so that a long render loses no digits. */
static void add_pass(const struct renderer *renderer, int px, int py) {
    size_t pixel = pixel_number(renderer, px, py);
    uint32_t pixel_seed = sampler_hash(renderer->desc.seed, (uint32_t)pixel);
    float layers[LAYER_COUNT] = {0};
    for (uint32_t stream = 0; stream < STREAMS; stream++) {
        float indirect[3] = {0};
        uint32_t seed = sampler_hash(pixel_seed, stream);
        for (uint32_t i = renderer->done; i < renderer->end; i++)
            add_sample(renderer, px, py, seed, i, layers, indirect);
        for (int c = 0; c < 3; c++)
            renderer->indirect[pixel][stream][c] += indirect[c];
    }
    float *sums = image_at(renderer->image, px, py);
    for (int c = 0; c < LAYER_COUNT; c++)
        sums[c] += layers[c];
}

/* The mean of the pixel's indirect light and the variance of that mean, from the spread of its
 * streams. */
static void pixel_statistics(const struct renderer *renderer, int px, int py, double mean[3],
                             double variance[3]) {
    float(*sums)[3] = renderer->indirect[pixel_number(renderer, px, py)];
    double points = renderer->done;
    for (int c = 0; c < 3; c++) {
        double sum = 0, sum2 = 0;
        for (int s = 0; s < STREAMS; s++)
            sum += sums[s][c] / points;
        mean[c] = sum / STREAMS;
        for (int s = 0; s < STREAMS; s++)
            sum2 += pow(sums[s][c] / points - mean[c], 2);
        variance[c] = sum2 / (STREAMS - 1) / STREAMS;
    }
}

/* --- passes -------------------------------------------------------------------------------------
 */

/* With these low-dimensional integrands the error falls about as points^-0.75. */
static double points_needed(const struct renderer *renderer) {
    const struct path_tracer_desc *desc = &renderer->desc;
    if (desc->samples > 0)
        return ceil(desc->samples / (double)STREAMS);
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
        .samples = (int)renderer->done * STREAMS,
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
    double mean_sum = 0, variance_sum = 0;
    for (int y = 0; y < renderer->desc.height; y++)
        for (int x = 0; x < renderer->desc.width; x++) {
            double mean[3], variance[3];
            pixel_statistics(renderer, x, y, mean, variance);
            for (int c = 0; c < 3; c++) {
                mean_sum += mean[c];
                variance_sum += variance[c];
            }
        }
    double values = 3.0 * renderer->desc.width * renderer->desc.height;
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

/* Low-discrepancy points are best by powers of two; between them only their middles are any good.
 */
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

/* --- the picture --------------------------------------------------------------------------------
 */

static void finish_pixel(const struct renderer *renderer, int px, int py) {
    float *layers = image_at(renderer->image, px, py);
    uint32_t samples = STREAMS * renderer->done;
    double mean[3], variance[3];
    for (int c = 0; c < LAYER_COUNT; c++)
        layers[c] /= (float)samples;
    pixel_statistics(renderer, px, py, mean, variance);
    for (int c = 0; c < 3; c++) {
        layers[LAYER_INDIRECT + c] = (float)mean[c];
        layers[LAYER_STANDARD_ERROR + c] = (float)sqrt(variance[c]);
    }
    glm_vec3_normalize(&layers[LAYER_NORMAL]);
    struct hit hit;
    const struct camera *camera = renderer->desc.camera;
    if (look(renderer, (float)px + 0.5f, (float)py + 0.5f, &hit))
        layers[LAYER_DEPTH] = glms_vec3_dot(glms_vec3_sub(hit.position, vector(camera->eye)),
                                            vector(camera->forward));
}

static void finish_row(void *context, size_t row) {
    const struct renderer *renderer = context;
    for (int x = 0; x < renderer->desc.width; x++)
        finish_pixel(renderer, x, (int)row);
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

static void renderer_free(struct renderer *renderer) {
    free(renderer->indirect);
    ray_scene_free(&renderer->rays);
    pthread_mutex_destroy(&renderer->progress_lock);
}

bool path_tracer_render(const struct path_tracer_desc *desc, struct image *image,
                        struct path_tracer_progress *reached) {
    struct renderer renderer = {
        .desc = resolve(desc),
        .emitter = emitter_of(desc->light, desc->geometry),
        .image = image,
    };
    size_t pixel_count = (size_t)renderer.desc.width * (size_t)renderer.desc.height;
    struct hit_table table;
    hit_table_init(&table, desc->scene, desc->geometry);
    pthread_mutex_init(&renderer.progress_lock, NULL);
    image_init(image, renderer.desc.width, renderer.desc.height, PATH_TRACER_CHANNELS);
    renderer.indirect = mem_alloc(pixel_count, sizeof *renderer.indirect);
    bool ok = ray_scene_init(&renderer.rays, &table) && render_passes(&renderer);
    if (ok) {
        parallel_for((size_t)renderer.desc.height, renderer.desc.threads, finish_row, &renderer);
        if (reached)
            *reached =
                (struct path_tracer_progress){1, renderer.noise, (int)renderer.done * STREAMS};
    } else {
        image_free(image);
    }
    renderer_free(&renderer);
    hit_table_free(&table);
    return ok;
}
