#include "reference/path_tracer.h"

#include "reference/denoise.h"
#include "reference/film.h"
#include "reference/channels.h"
#include "reference/path.h"
#include "reference/rows.h"
#include "reference/primary.h"

#include "base/error.h"
#include "base/memory.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>

/* Samples of a pixel: of the first pass, and how many a forecast expects before it has seen any. */
enum { FIRST_PASS_SAMPLES = 32, EXPECTED_SAMPLES = 256 };

/* Indirect paths from each point that the camera sees: the noise is in them, not in the camera ray
 * and the direct light, whose rays are thus shared. Few samples want each its own point. */
enum { PATHS_PER_SAMPLE = 4, FEW_SAMPLES = 16 };

struct renderer {
    struct path_tracer_desc desc; /* resolved */
    struct ray_scene rays;
    struct primary_rays primary;
    struct emission emission;
    struct light_vertex *lights[FILM_STREAMS];
    struct film_pixel *pixels;
    struct image *image; /* once developed */
    uint32_t done, end;  /* samples of a pixel: of earlier passes, and after the present one */
    double noise;        /* after the last pass */
};

/* --- samples --- */

static struct film_pixel *pixel_at(const struct renderer *renderer, int x, int y) {
    return &renderer->pixels[(size_t)y * (size_t)renderer->desc.width + (size_t)x];
}

static vec3s mean_of_paths(const struct renderer *renderer, const struct hit *hit, int stream,
                           const struct sampler *start) {
    struct path_scene scene = {&renderer->rays, &renderer->emission, renderer->desc.bounces};
    uint32_t paths = (uint32_t)renderer->desc.paths;
    vec3s sum = glms_vec3_zero();
    for (uint32_t i = 0; i < paths; i++) {
        struct sampler sampler = {start->seed, start->index * paths + i, start->pair};
        vec3s light = path_indirect(&scene, renderer->lights[stream], hit, &sampler);
        sum = glms_vec3_add(sum, light);
    }
    return glms_vec3_scale(sum, 1 / (float)paths);
}

static int stream_of(uint32_t sample) {
    return (int)(sample % FILM_STREAMS);
}

/* What a pixel's i-th sample sees; false where that is nothing. */
static bool take_sample(const struct renderer *renderer, int px, int py, uint32_t i,
                        struct film_sample *sample) {
    const struct path_tracer_desc *desc = &renderer->desc;
    uint32_t pixel_number = (uint32_t)py * (uint32_t)desc->width + (uint32_t)px;
    uint32_t pixel_seed = sampler_hash(desc->seed, pixel_number);
    int stream = stream_of(i);
    struct sampler sampler = {.seed = sampler_hash(pixel_seed, (uint32_t)stream),
                              .index = i / FILM_STREAMS};
    vec2s jitter = sampler_next(&sampler), at = desc->centers ? (vec2s){{0.5f, 0.5f}} : jitter;
    struct hit hit;
    if (!primary_hit(&renderer->primary, (float)px + at.x, (float)py + at.y, &hit))
        return false;
    *sample = (struct film_sample){
        .position = hit.position,
        .albedo = hit.albedo,
        .normal = hit.normal,
        .direct = emission_direct(&renderer->emission, &renderer->rays, &hit),
        .indirect = mean_of_paths(renderer, &hit, stream, &sampler),
    };
    return true;
}

/* Sums of a pass are made apart, so that a long render loses no digits. */
static void add_pass(const struct renderer *renderer, int px, int py) {
    struct film_pixel sums = {0};
    struct film_sample sample;
    for (uint32_t i = renderer->done; i < renderer->end; i++)
        if (take_sample(renderer, px, py, i, &sample))
            film_pixel_add(&sums, stream_of(i), &sample);
    film_pixel_merge(pixel_at(renderer, px, py), &sums);
}

/* --- passes --- */

/* With these low-dimensional integrands the error falls about as samples^-0.75. */
static double samples_needed(const struct renderer *renderer) {
    const struct path_tracer_desc *desc = &renderer->desc;
    if (desc->samples > 0)
        return desc->samples;
    if (renderer->done == 0)
        return EXPECTED_SAMPLES;
    return renderer->done * pow(renderer->noise / desc->noise, 1 / 0.75);
}

/* rows_done: the share of the present pass. */
static bool report(void *context, double rows_done) {
    const struct renderer *renderer = context;
    const struct path_tracer_desc *desc = &renderer->desc;
    double samples = renderer->done + (renderer->end - renderer->done) * rows_done;
    struct path_tracer_progress progress = {
        .done = samples / fmax(samples_needed(renderer), renderer->end),
        .noise = renderer->noise,
        .samples = (int)renderer->done,
    };
    return !desc->progress || desc->progress(desc->user, &progress);
}

static void add_pass_to_row(void *context, int row) {
    const struct renderer *renderer = context;
    for (int x = 0; x < renderer->desc.width; x++)
        add_pass(renderer, x, row);
}

/* Standard error, RMS over pixels and channels, over the mean. A pixel counts as far as it is
 * covered: of slivers at silhouettes few samples tell, and little of them is seen. */
static double estimate_noise(const struct renderer *renderer) {
    size_t pixel_count = (size_t)renderer->desc.width * (size_t)renderer->desc.height;
    double samples = renderer->done, mean_sum = 0, variance_sum = 0;
    for (size_t i = 0; i < pixel_count; i++) {
        const struct film_pixel *pixel = &renderer->pixels[i];
        struct film_estimate estimate = film_pixel_estimate(pixel);
        double alpha = pixel->coverage / samples;
        for (int c = 0; c < 3; c++) {
            mean_sum += alpha * estimate.mean[c];
            variance_sum += alpha * alpha * estimate.variance[c];
        }
    }
    double values = 3 * (double)pixel_count;
    return mean_sum > 0 ? sqrt(variance_sum / values) / (mean_sum / values) : 0;
}

static bool render_pass(struct renderer *renderer, uint32_t end) {
    const struct path_tracer_desc *desc = &renderer->desc;
    renderer->end = end;
    if (!rows_render(
            &(struct rows){desc->height, desc->threads, add_pass_to_row, report, renderer}))
        return false;
    renderer->done = end;
    renderer->noise = estimate_noise(renderer);
    return true;
}

/* A quarter of the greatest power of two below: the picture is done soon after it is good enough,
 * and the powers of two, where low-discrepancy points are best, are not stepped over. */
static uint32_t next_end(uint32_t done) {
    uint32_t power = 1;
    while (power <= done / 2)
        power *= 2;
    return done + power / 4;
}

static bool render_passes(struct renderer *renderer) {
    if (renderer->desc.samples > 0)
        return render_pass(renderer, (uint32_t)renderer->desc.samples);
    bool ok = render_pass(renderer, FIRST_PASS_SAMPLES);
    while (ok && renderer->noise > renderer->desc.noise)
        ok = render_pass(renderer, next_end(renderer->done));
    return ok;
}

/* --- the picture --- */

static void develop_row(void *context, int row) {
    const struct renderer *renderer = context;
    int samples = (int)renderer->done;
    for (int x = 0; x < renderer->desc.width; x++) {
        struct hit center;
        float *channels = image_at(renderer->image, x, row);
        film_pixel_develop(pixel_at(renderer, x, row), samples, channels);
        if (primary_hit(&renderer->primary, (float)x + 0.5f, (float)row + 0.5f, &center))
            channels[CHANNEL_DEPTH] = primary_depth(&renderer->primary, center.position);
    }
}

static bool develop(struct renderer *renderer) {
    const struct path_tracer_desc *desc = &renderer->desc;
    image_init(renderer->image, desc->width, desc->height, CHANNELS_OF_PATH_TRACER);
    return rows_render(&(struct rows){desc->height, desc->threads, develop_row, NULL, renderer});
}

static struct path_tracer_desc resolve(const struct path_tracer_desc *desc) {
    struct path_tracer_desc resolved = *desc;
    assert(desc->scene && desc->geometry && desc->camera && desc->emitters.count &&
           desc->bounces >= 0);
    if (resolved.width == 0)
        resolved.width = 800;
    if (resolved.height == 0)
        resolved.height = 800;
    if (resolved.noise == 0)
        resolved.noise = 0.01;
    if (resolved.paths == 0)
        resolved.paths = desc->samples > 0 && desc->samples < FEW_SAMPLES ? 1 : PATHS_PER_SAMPLE;
    return resolved;
}

static void trace_lights(struct renderer *renderer) {
    const struct path_tracer_desc *desc = &renderer->desc;
    int used = desc->samples > 0 && desc->samples < FILM_STREAMS ? desc->samples : FILM_STREAMS;
    for (int stream = 0; stream < used && desc->bounces > 0; stream++)
        renderer->lights[stream] =
            light_vertices_trace(&renderer->emission, &renderer->rays,
                                 sampler_hash(~desc->seed, (uint32_t)stream), desc->threads);
}

static bool render(struct renderer *renderer, const struct hit_table *table) {
    if (!ray_scene_init(&renderer->rays, table))
        return false;
    trace_lights(renderer);
    if (!render_passes(renderer) || !develop(renderer))
        return false;
    if (renderer->desc.denoise)
        denoise(&(struct denoise_desc){.pixels = renderer->pixels,
                                       .primary = &renderer->primary,
                                       .samples = (int)renderer->done,
                                       .paths = renderer->desc.paths,
                                       .threads = renderer->desc.threads},
                renderer->image);
    return true;
}

/* Beside the picture each pixel has its sums. */
static bool check_memory(const struct path_tracer_desc *desc) {
    uint64_t pixels = (uint64_t)desc->width * (uint64_t)desc->height;
    uint64_t of_pixel = sizeof(struct film_pixel) + sizeof(float) * (CHANNEL_STANDARD_ERROR + 3);
    return mem_check(pixels * of_pixel) ||
           error_prefix("a reference of %dx%d", desc->width, desc->height);
}

bool path_tracer_render(const struct path_tracer_desc *desc, struct image *image,
                        struct path_tracer_progress *reached) {
    struct renderer renderer = {.desc = resolve(desc), .image = image};
    struct hit_table table;
    *image = (struct image){0};
    desc = &renderer.desc;
    if (!check_memory(desc))
        return false;
    hit_table_init(&table, desc->scene, desc->geometry);
    emission_init(&renderer.emission, &desc->emitters, desc->geometry, LIGHT_VERTEX_COUNT);
    renderer.primary =
        (struct primary_rays){&renderer.rays, desc->camera, desc->width, desc->height};
    renderer.pixels =
        mem_alloc((size_t)desc->width * (size_t)desc->height, sizeof *renderer.pixels);
    bool ok = render(&renderer, &table);
    if (ok && reached)
        *reached = (struct path_tracer_progress){1, renderer.noise, (int)renderer.done};
    for (int stream = 0; stream < FILM_STREAMS; stream++)
        free(renderer.lights[stream]);
    free(renderer.pixels);
    emission_free(&renderer.emission);
    ray_scene_free(&renderer.rays);
    hit_table_free(&table);
    return ok;
}
