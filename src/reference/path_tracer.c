#define _POSIX_C_SOURCE 200809L
#include "reference/path_tracer.h"

#include "reference/airlight.h"
#include "reference/ao.h"
#include "reference/chain.h"
#include "reference/channels.h"
#include "reference/denoise.h"
#include "reference/film.h"
#include "reference/path.h"
#include "reference/primary.h"
#include "reference/rows.h"
#include "reference/smooth.h"
#include "scene/lights/environment.h"
#include "scene/medium.h"

#include "base/error.h"
#include "base/halton.h"
#include "base/memory.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* Samples of a pixel: of the first pass, and how many a forecast expects before it has seen any. */
/* EXPECTED_SAMPLES: of a usual scene, for a noise of 1 %. */
enum { FIRST_PASS_SAMPLES = 32, EXPECTED_SAMPLES = 256 };
static const uint32_t samples_most = 1 << 20;

/* Indirect paths from each point that the camera sees: the noise is in them, not in the camera ray
 * and the direct light, whose rays are thus shared. Few samples want each its own point. */
enum { PATHS_PER_SAMPLE = 4, FEW_SAMPLES = 16 };

struct tracer {
    struct path_tracer_desc
        desc; /* resolved; width and height are those of the picture that comes out */
    struct ray_scene rays;
    struct primary_rays primary;
    struct emission emission;
    struct light_vertices lights[FILM_STREAMS];
    struct film_pixel *pixels;
    struct film_seen *seen;         /* where it is wanted */
    struct film_specular *specular; /* where there is some */
    struct ao_sums *ao;             /* where it is wanted */
    struct film_airlight *airlight; /* where there is a medium */
    struct image *image;            /* once developed */
    uint32_t done, end;  /* samples of a pixel: of earlier passes, and after the present one */
    double noise;        /* after the last pass */
    uint32_t first_done; /* both after the first */
    double first_noise;
};

/* --- samples --- */

static size_t index_of(const struct tracer *tracer, int x, int y) {
    return (size_t)y * (size_t)tracer->desc.width + (size_t)x;
}

/* The first of the channels that only some pictures have. */
static int first_of_more(const struct tracer *tracer) {
    return tracer->desc.seen ? CHANNEL_END : CHANNEL_PATH_TRACER_END;
}

/* Of the picture's channels, the first of specular reflection; 0 = it has none. */
static int specular_channel(const struct tracer *tracer) {
    return tracer->specular ? first_of_more(tracer) : 0;
}

static int ao_channel(const struct tracer *tracer) {
    return first_of_more(tracer) + (tracer->specular ? SPECULAR_END : 0);
}

/* And of airlight, which comes last. */
static int airlight_channel(const struct tracer *tracer) {
    return ao_channel(tracer) + (tracer->ao ? AO_END : 0);
}

static struct reflected mean_of_paths(const struct tracer *tracer, const struct hit *hit,
                                      int stream, const struct sampler *start) {
    struct path_scene scene = {&tracer->rays, &tracer->emission, tracer->desc.bounces};
    uint32_t paths = (uint32_t)tracer->desc.paths;
    struct reflected sum = {0};
    for (uint32_t i = 0; i < paths; i++) {
        struct sampler sampler = {start->seed, start->index * paths + i, start->pair};
        struct reflected light = path_indirect(&scene, &tracer->lights[stream], hit, &sampler);
        sum.diffuse = glms_vec3_add(sum.diffuse, light.diffuse);
        sum.specular = glms_vec3_add(sum.specular, light.specular);
    }
    return (struct reflected){glms_vec3_scale(sum.diffuse, 1 / (float)paths),
                              glms_vec3_scale(sum.specular, 1 / (float)paths)};
}

/* The indirect paths' samplers, at pairs that no path comes to. */
enum {
    DIRECT_PAIRS = 1 << 20,
    AIRLIGHT_PAIRS = 1 << 21,
    CHAIN_PAIRS = 1 << 22,
    AO_PAIRS = 1 << 30
};

struct samplers {
    struct sampler items[PATHS_PER_SAMPLE];
};

static struct samplers samplers_at(const struct sampler *start, uint32_t first_pair) {
    struct samplers samplers;
    for (uint32_t i = 0; i < PATHS_PER_SAMPLE; i++)
        samplers.items[i] =
            (struct sampler){start->seed, start->index * PATHS_PER_SAMPLE + i, first_pair};
    return samplers;
}

static int stream_of(uint32_t sample) {
    return (int)(sample % FILM_STREAMS);
}

static vec3s sky_radiance(const struct tracer *tracer, vec3s direction) {
    const struct environment *sky = tracer->desc.emitters.sky;
    vec3s radiance = glms_vec3_zero();
    if (sky)
        environment_radiance(sky, direction.raw, radiance.raw);
    return radiance;
}

/* Where no surface is seen. */
static vec3s background(const struct tracer *tracer, vec3s direction) {
    return tracer->desc.hides_sky ? glms_vec3_zero() : sky_radiance(tracer, direction);
}

static void add_seen(const struct tracer *tracer, const struct hit *hit, int stream,
                     const struct samplers *samplers, struct film_seen *sums) {
    struct seen seen =
        seen_from(&tracer->emission, &tracer->rays, hit, samplers->items, PATHS_PER_SAMPLE);
    film_seen_add(sums, stream, hit->brdf.albedo, &seen);
}

static void add_ao(const struct tracer *tracer, const struct hit *hit, int stream,
                   const struct sampler *start, struct ao_sums *sums) {
    struct samplers samplers = samplers_at(start, AO_PAIRS);
    ao_add(
        sums, stream,
        ao_trace(&tracer->rays, hit, tracer->desc.ao_distance, samplers.items, PATHS_PER_SAMPLE));
}

/* Sums of a pixel. */
struct sums {
    struct film_pixel pixel;
    struct film_seen seen;
    struct film_specular specular;
    struct ao_sums ao;
    struct film_airlight airlight;
};

/* A ray of the camera, and how far it sees. */
struct sight {
    vec3s origin, direction;
    float length;
};

static struct sight sight_to(const struct tracer *tracer, float x, float y, const struct hit *hit) {
    struct sight sight = {.length = INFINITY};
    primary_ray(&tracer->primary, x, y, &sight.origin, &sight.direction);
    if (hit)
        sight.length = glms_vec3_distance(sight.origin, hit->position);
    return sight;
}

static void add_airlight(const struct tracer *tracer, const struct sight *sight, int stream,
                         const struct sampler *start, struct sums *sums) {
    struct samplers samplers = samplers_at(start, AIRLIGHT_PAIRS);
    vec3s light = airlight_along(&tracer->emission, &tracer->rays, sight->origin, sight->direction,
                                 sight->length, samplers.items, PATHS_PER_SAMPLE);
    film_airlight_add(&sums->airlight, &sums->pixel, stream, light);
}

/* Direct and indirect light that a surface reflects. */
static void light_surface(const struct tracer *tracer, const struct hit *hit, int stream,
                          const struct sampler *sampler, const struct samplers *samplers,
                          struct film_sample *sample) {
    if (tracer->desc.ao_alone)
        return;
    sample->direct =
        emission_direct(&tracer->emission, &tracer->rays, hit, samplers->items, PATHS_PER_SAMPLE);
    sample->indirect = mean_of_paths(tracer, hit, stream, sampler);
}

static vec3s glow_of(const struct tracer *tracer, const struct hit *hit) {
    return glms_vec3_add(surfaces_glow(&tracer->emission.surfaces, hit), hit->unlit);
}

/* What glass or a mirror shows is specular light: direct light is what the lights send to the place
 * that is seen, and what shines itself. away: of the camera, which may be in glass, metres. */
static void light_smooth(const struct tracer *tracer, const struct hit *hit, float away, int stream,
                         const struct sampler *sampler, const struct samplers *samplers,
                         struct film_sample *sample) {
    struct sampler steps = {sampler->seed, sampler->index, CHAIN_PAIRS};
    struct chain chain = chain_follow(&tracer->emission, &tracer->rays, hit, &steps);
    const struct material *around = smooth_inside(hit, NULL); /* a camera in glass */
    vec3s passes = around ? smooth_passes(around, away) : glms_vec3_one();
    struct film_sample seen = {0};
    vec3s shines = glms_vec3_zero();
    if (chain.hits) {
        light_surface(tracer, &chain.end, stream, sampler, samplers, &seen);
        shines = glow_of(tracer, &chain.end);
    } else if (!chain.cut) {
        shines = sky_radiance(tracer, chain.direction);
    }
    if (chain.hits) {
        shines = glms_vec3_add(shines, hit_radiance(&chain.end, &seen.direct));
        sample->indirect.specular =
            glms_vec3_mul(chain.share, hit_radiance(&chain.end, &seen.indirect));
    }
    sample->direct.specular = glms_vec3_add(chain.between, glms_vec3_mul(chain.share, shines));
    sample->direct.specular = glms_vec3_mul(passes, sample->direct.specular);
    sample->indirect.specular = glms_vec3_mul(passes, sample->indirect.specular);
}

static void add_surface(const struct tracer *tracer, const struct hit *hit,
                        const struct sight *sight, vec3s passes, int stream,
                        const struct sampler *sampler, struct sums *sums) {
    struct samplers samplers = samplers_at(sampler, DIRECT_PAIRS);
    struct film_sample sample = {
        .position = hit->position,
        .albedo = hit->brdf.albedo,
        .normal = hit->normal,
        .emitted = glow_of(tracer, hit),
        .passes = passes,
    };
    if (hit->smooth)
        light_smooth(tracer, hit, sight->length, stream, sampler, &samplers, &sample);
    else
        light_surface(tracer, hit, stream, sampler, &samplers, &sample);
    film_pixel_add(&sums->pixel, stream, &sample);
    if (tracer->specular)
        film_specular_add(&sums->specular, stream, &sample);
    if (tracer->desc.seen)
        add_seen(tracer, hit, stream, &samplers, &sums->seen);
    if (tracer->ao)
        add_ao(tracer, hit, stream, sampler, &sums->ao);
}

/* Adds what a pixel's i-th sample sees. */
static void take_sample(const struct tracer *tracer, int px, int py, uint32_t i,
                        struct sums *sums) {
    const struct path_tracer_desc *desc = &tracer->desc;
    uint32_t pixel_number = (uint32_t)py * (uint32_t)desc->width + (uint32_t)px;
    uint32_t pixel_seed = sampler_hash(desc->seed, pixel_number);
    int stream = stream_of(i);
    struct sampler sampler = {.seed = sampler_hash(pixel_seed, (uint32_t)stream),
                              .index = i / FILM_STREAMS};
    vec2s jitter = sampler_next(&sampler), at = desc->centers ? (vec2s){{0.5f, 0.5f}} : jitter;
    struct pixel pixel = path_tracer_pixel(desc->every, px, py);
    float x = (float)pixel.x + at.x, y = (float)pixel.y + at.y;
    struct hit hit;
    bool hits = primary_hit(&tracer->primary, x, y, i, &hit);
    struct sight sight = sight_to(tracer, x, y, hits ? &hit : NULL);
    vec3s passes =
        medium_transmittance(&tracer->emission.medium, sight.origin, sight.direction, sight.length);
    passes = glms_vec3_mul(passes, hit.share);
    if (tracer->airlight)
        add_airlight(tracer, &sight, stream, &sampler, sums);
    if (hits)
        add_surface(tracer, &hit, &sight, passes, stream, &sampler, sums);
    else
        film_pixel_add_background(&sums->pixel, background(tracer, sight.direction), passes);
}

/* Sums of a pass are made apart, so that a long render loses no digits. */
static void add_pass(const struct tracer *tracer, int px, int py) {
    struct sums sums = {0};
    for (uint32_t i = tracer->done; i < tracer->end; i++)
        take_sample(tracer, px, py, i, &sums);
    film_pixel_merge(&tracer->pixels[index_of(tracer, px, py)], &sums.pixel);
    if (tracer->seen)
        film_seen_merge(&tracer->seen[index_of(tracer, px, py)], &sums.seen);
    if (tracer->specular)
        film_specular_merge(&tracer->specular[index_of(tracer, px, py)], &sums.specular);
    if (tracer->ao)
        ao_merge(&tracer->ao[index_of(tracer, px, py)], &sums.ao);
    if (tracer->airlight)
        film_airlight_merge(&tracer->airlight[index_of(tracer, px, py)], &sums.airlight);
}

/* --- passes --- */

/* The power of samples by which the noise falls: about .75 with integrands of few dimensions, .5
 * where it is chance alone, as of caustics; as it has fallen so far, once that tells. */
static double falls_by(const struct tracer *tracer) {
    double times = (double)tracer->done / tracer->first_done;
    if (times < 2)
        return .75;
    return fmin(fmax(log(tracer->first_noise / tracer->noise) / log(times), .5), .75);
}

static double samples_needed(const struct tracer *tracer) {
    const struct path_tracer_desc *desc = &tracer->desc;
    if (desc->samples > 0)
        return desc->samples;
    if (tracer->done == 0)
        return EXPECTED_SAMPLES * pow(.01 / desc->noise, 1 / .75);
    return tracer->done * pow(tracer->noise / desc->noise, 1 / falls_by(tracer));
}

/* rows_done: the share of the present pass. */
static bool report(void *context, double rows_done) {
    const struct tracer *tracer = context;
    const struct path_tracer_desc *desc = &tracer->desc;
    double samples = tracer->done + (tracer->end - tracer->done) * rows_done;
    struct path_tracer_progress progress = {
        .done = samples / fmax(samples_needed(tracer), tracer->end),
        .noise = tracer->noise,
        .samples = (int)tracer->done,
    };
    return !desc->progress || desc->progress(desc->user, &progress);
}

static void add_pass_to_row(void *context, int row) {
    const struct tracer *tracer = context;
    for (int x = 0; x < tracer->desc.width; x++)
        add_pass(tracer, x, row);
}

/* Standard error, RMS over pixels and channels, over the mean. A pixel counts as far as it is
 * covered: of slivers at silhouettes few samples tell, and little of them is seen. */
static double estimate_noise(const struct tracer *tracer) {
    size_t pixel_count = (size_t)tracer->desc.width * (size_t)tracer->desc.height;
    double samples = tracer->done, mean_sum = 0, variance_sum = 0;
    for (size_t i = 0; i < pixel_count; i++) {
        const struct film_pixel *pixel = &tracer->pixels[i];
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

/* The same of the direct light, which has noise where a light has a size or lights are sampled. */
static double estimate_direct_noise(const struct tracer *tracer) {
    size_t pixel_count = (size_t)tracer->desc.width * (size_t)tracer->desc.height;
    double mean_sum = 0, variance_sum = 0;
    bool is_noisy = tracer->emission.has_sizes || tracer->emission.has_tree;
    for (size_t i = 0; is_noisy && i < pixel_count; i++) {
        struct film_direct_estimate estimate = film_pixel_estimate_direct(&tracer->pixels[i]);
        double alpha = (double)tracer->pixels[i].coverage / tracer->done;
        mean_sum += alpha * estimate.mean;
        variance_sum += alpha * alpha * estimate.variance;
    }
    return mean_sum > 0 ? sqrt(variance_sum * (double)pixel_count) / mean_sum : 0;
}

/* The same of specular light, or of airlight, but over the beauty's mean: there may be little of
 * it. */
static double estimate_radiance_noise(const struct tracer *tracer, bool is_airlight) {
    size_t pixel_count = (size_t)tracer->desc.width * (size_t)tracer->desc.height;
    double beauty_sum = 0, variance_sum = 0, values = 3 * (double)pixel_count;
    for (size_t i = 0; i < pixel_count; i++) {
        struct film_estimate estimate =
            is_airlight ? film_airlight_estimate(&tracer->airlight[i], (int)tracer->done)
                        : film_specular_estimate(&tracer->specular[i], (int)tracer->done);
        for (int c = 0; c < 3; c++) {
            beauty_sum += (double)tracer->pixels[i].beauty[c] / tracer->done;
            variance_sum += estimate.variance[c];
        }
    }
    return beauty_sum > 0 ? sqrt(variance_sum * values) / beauty_sum : 0;
}

static double estimate_ao_noise(const struct tracer *tracer) {
    size_t pixel_count = (size_t)tracer->desc.width * (size_t)tracer->desc.height;
    return tracer->ao ? ao_noise(tracer->ao, pixel_count, (int)tracer->done) : 0;
}

static bool render_pass(struct tracer *tracer, uint32_t end) {
    const struct path_tracer_desc *desc = &tracer->desc;
    tracer->end = end;
    if (!rows_render(&(struct rows){desc->height, desc->threads, add_pass_to_row, report, tracer}))
        return false;
    tracer->done = end;
    tracer->noise = fmax(estimate_noise(tracer), estimate_direct_noise(tracer));
    tracer->noise = fmax(tracer->noise, estimate_ao_noise(tracer));
    if (tracer->specular)
        tracer->noise = fmax(tracer->noise, estimate_radiance_noise(tracer, false));
    if (tracer->airlight)
        tracer->noise = fmax(tracer->noise, estimate_radiance_noise(tracer, true));
    if (tracer->first_done == 0) {
        tracer->first_done = tracer->done;
        tracer->first_noise = tracer->noise;
    }
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

/* --- the picture --- */

static void develop_row(void *context, int row) {
    const struct tracer *tracer = context;
    int samples = (int)tracer->done;
    for (int x = 0; x < tracer->desc.width; x++) {
        struct hit center;
        float *channels = image_at(tracer->image, x, row);
        film_pixel_develop(&tracer->pixels[index_of(tracer, x, row)], samples, channels);
        if (tracer->seen)
            film_seen_develop(&tracer->seen[index_of(tracer, x, row)],
                              &tracer->pixels[index_of(tracer, x, row)], channels);
        if (tracer->specular)
            film_specular_develop(&tracer->specular[index_of(tracer, x, row)], samples,
                                  &channels[specular_channel(tracer)]);
        if (tracer->ao)
            ao_develop(&tracer->ao[index_of(tracer, x, row)], &channels[ao_channel(tracer)]);
        if (tracer->airlight)
            film_airlight_develop(&tracer->airlight[index_of(tracer, x, row)], samples,
                                  &channels[airlight_channel(tracer)]);
        struct pixel pixel = path_tracer_pixel(tracer->desc.every, x, row);
        float at[2] = {(float)pixel.x + 0.5f, (float)pixel.y + 0.5f};
        if (primary_hit(&tracer->primary, at[0], at[1], 0, &center))
            channels[CHANNEL_DEPTH] = primary_depth(&tracer->primary, center.position);
    }
}

static bool develop(struct tracer *tracer) {
    const struct path_tracer_desc *desc = &tracer->desc;
    char channels[1024];
    snprintf(channels, sizeof channels, "%s%s%s%s%s", CHANNELS_OF_PATH_TRACER,
             desc->seen ? " " CHANNELS_OF_SEEN : "",
             tracer->specular ? " " CHANNELS_OF_SPECULAR : "", tracer->ao ? " " CHANNELS_OF_AO : "",
             tracer->airlight ? " " CHANNELS_OF_AIRLIGHT : "");
    image_init(tracer->image, desc->width, desc->height, channels);
    return rows_render(&(struct rows){desc->height, desc->threads, develop_row, NULL, tracer});
}

/* Returns the number of Hammersley points: the samples done, at most 256. */
static int matte_samples(const struct tracer *tracer) {
    return tracer->done < 256 ? (int)tracer->done : 256;
}

static uint32_t *look(void *user, int i) {
    const struct tracer *tracer = user;
    const float place[2] = {((float)i + .5F) / (float)matte_samples(tracer),
                            (float)radical_inverse(2, (uint32_t)i)};
    return primary_triangles(&tracer->primary, place, tracer->desc.threads);
}

static void append_surfaces(struct tracer *tracer) {
    const struct path_tracer_desc *desc = &tracer->desc;
    uint32_t *centers = primary_triangles(&tracer->primary, (float[]){.5F, .5F}, desc->threads);
    const struct surface_view view = {desc->scene,  desc->geometry,        desc->camera, centers,
                                      desc->motion, matte_samples(tracer), look,         tracer};
    surface_layers_append(&view, desc->surface_layers, tracer->image);
    free(centers);
}

/* To who watches. */
static bool show(struct tracer *tracer) {
    struct path_tracer_progress reached = {.noise = tracer->noise, .samples = (int)tracer->done};
    if (!tracer->desc.show)
        return true;
    bool ok = develop(tracer);
    if (ok)
        tracer->desc.show(tracer->desc.user, tracer->image, &reached);
    image_free(tracer->image);
    return ok;
}

static bool render_passes(struct tracer *tracer) {
    if (tracer->desc.samples > 0)
        return render_pass(tracer, (uint32_t)tracer->desc.samples);
    bool ok = render_pass(tracer, tracer->desc.show ? FILM_STREAMS : FIRST_PASS_SAMPLES);
    while (ok && tracer->noise > tracer->desc.noise && tracer->done < samples_most)
        ok = show(tracer) && render_pass(tracer, next_end(tracer->done));
    return ok;
}

static struct path_tracer_desc resolve(const struct path_tracer_desc *desc) {
    struct path_tracer_desc resolved = *desc;
    assert(desc->scene && desc->geometry && desc->camera &&
           (desc->emitters.count || desc->emitters.sky) && desc->bounces >= 0 &&
           desc->ao_distance >= 0);
    if (resolved.width == 0)
        resolved.width = 800;
    if (resolved.height == 0)
        resolved.height = 800;
    if (resolved.every == 0)
        resolved.every = 1;
    assert(resolved.width >= resolved.every && resolved.height >= resolved.every &&
           (resolved.every == 1 || (!resolved.denoise && !resolved.surface_layers)));
    if (resolved.noise == 0)
        resolved.noise = 0.01;
    if (resolved.paths == 0)
        resolved.paths = desc->samples > 0 && desc->samples < FEW_SAMPLES ? 1 : PATHS_PER_SAMPLE;
    return resolved;
}

static void trace_lights(struct tracer *tracer) {
    const struct path_tracer_desc *desc = &tracer->desc;
    int used = desc->samples > 0 && desc->samples < FILM_STREAMS ? desc->samples : FILM_STREAMS;
    for (int stream = 0; stream < used && desc->bounces > 0; stream++)
        tracer->lights[stream] =
            light_vertices_trace(&tracer->emission, &tracer->rays,
                                 sampler_hash(~desc->seed, (uint32_t)stream), desc->threads);
}

static bool render(struct tracer *tracer, const struct hit_table *table) {
    if (!ray_scene_init(&tracer->rays, table))
        return false;
    trace_lights(tracer);
    if (!render_passes(tracer) || !develop(tracer))
        return false;
    if (tracer->desc.denoise)
        denoise(&(struct denoise_desc){.pixels = tracer->pixels,
                                       .primary = &tracer->primary,
                                       .samples = (int)tracer->done,
                                       .paths = tracer->desc.paths,
                                       .specular_channel = specular_channel(tracer),
                                       .airlight_channel =
                                           tracer->airlight ? airlight_channel(tracer) : 0,
                                       .threads = tracer->desc.threads},
                tracer->image);
    if (tracer->desc.surface_layers)
        append_surfaces(tracer);
    return true;
}

/* Beside the picture each pixel has its sums. */
static bool check_memory(const struct path_tracer_desc *desc) {
    uint64_t pixels = (uint64_t)desc->width * (uint64_t)desc->height;
    uint64_t of_pixel = sizeof(struct film_pixel) + sizeof(float) * CHANNEL_PATH_TRACER_END;
    if (desc->seen)
        of_pixel +=
            sizeof(struct film_seen) + sizeof(float) * (CHANNEL_END - CHANNEL_PATH_TRACER_END);
    if (desc->materials == MATERIALS_FULL && !materials_are_plain(desc->scene))
        of_pixel += sizeof(struct film_specular) + sizeof(float) * SPECULAR_END;
    if (desc->ao_distance > 0)
        of_pixel += sizeof(struct ao_sums) + sizeof(float) * AO_END;
    if (medium_exists(&desc->medium))
        of_pixel += sizeof(struct film_airlight) + sizeof(float) * AIRLIGHT_END;
    return mem_check(pixels * of_pixel) ||
           error_prefix("a reference of %dx%d", desc->width, desc->height);
}

struct pixel path_tracer_pixel(int every, int x, int y) {
    uint32_t chance = sampler_hash((uint32_t)x, (uint32_t)y), n = (uint32_t)every;
    return (struct pixel){x * every + (int)(chance % n), y * every + (int)(chance / n % n)};
}

bool path_tracer_render(const struct path_tracer_desc *desc, struct image *image,
                        struct path_tracer_progress *reached) {
    struct tracer tracer = {.desc = resolve(desc), .image = image};
    struct hit_table table;
    *image = (struct image){0};
    desc = &tracer.desc;
    tracer.primary =
        primary_rays_of(&tracer.rays, desc->camera, desc->geometry, desc->width, desc->height);
    tracer.primary.sensors = desc->sensors;
    tracer.desc.width /= desc->every;
    tracer.desc.height /= desc->every;
    if (!check_memory(desc))
        return false;
    hit_table_init(&table, desc->scene, desc->geometry, (enum materials)desc->materials);
    if (desc->smooth)
        hit_table_find_smooth(&table);
    emission_init(&tracer.emission, &desc->emitters, desc->geometry, &table, LIGHT_VERTEX_COUNT);
    tracer.emission.medium = medium_ball_of(&desc->medium, desc->geometry);
    size_t pixels = (size_t)desc->width * (size_t)desc->height;
    tracer.pixels = mem_alloc(pixels, sizeof *tracer.pixels);
    tracer.seen = desc->seen ? mem_alloc(pixels, sizeof *tracer.seen) : NULL;
    tracer.specular = table.has_specular ? mem_alloc(pixels, sizeof *tracer.specular) : NULL;
    tracer.ao = desc->ao_distance > 0 ? mem_alloc(pixels, sizeof *tracer.ao) : NULL;
    tracer.airlight =
        medium_exists(&desc->medium) ? mem_alloc(pixels, sizeof *tracer.airlight) : NULL;
    bool ok = render(&tracer, &table);
    if (ok && reached)
        *reached = (struct path_tracer_progress){1, tracer.noise, (int)tracer.done};
    for (int stream = 0; stream < FILM_STREAMS; stream++)
        light_vertices_free(&tracer.lights[stream]);
    mem_free(tracer.pixels, tracer.seen, tracer.specular, tracer.ao, tracer.airlight);
    emission_free(&tracer.emission);
    ray_scene_free(&tracer.rays);
    return ok;
}
