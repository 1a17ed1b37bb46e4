#include "reference/light_tracer.h"

#include "reference/light_path.h"
#include "scene/medium.h"

#include "base/error.h"
#include "base/memory.h"
#include "base/parallel.h"

#include <assert.h>

/* Batches tell the noise. Chunks of rays are traced at once, a wave of them, and what they leave is
 * added in their order: sums do not depend on threads. */
enum { BATCHES = 16, RAYS_PER_BATCH = 64, CHUNK = 1024, WAVE = 64 };

struct chunk {
    int light;
    uint32_t first, count; /* of the light's rays */
    struct light_deposits deposits;
    struct light_balance balance;
};

struct light_tracer {
    struct light_tracer_desc desc;
    struct ray_scene rays;
    struct emission emission;
    struct light_aim aim;
    struct light_path_scene scene;
    struct light_film film;
    struct light_balance balance;
    int batch, batches;
    int *counts; /* rays of each light in a batch */
    struct chunk chunks[WAVE];
};

static void trace_ray(const struct light_tracer *tracer, struct chunk *chunk, uint32_t i) {
    uint32_t seed = sampler_hash(tracer->desc.seed ^ 0x6c696768U, (uint32_t)tracer->batch);
    struct sampler sampler = {.seed = sampler_hash(seed, (uint32_t)chunk->light), .index = i};
    vec2s sample = sampler_next(&sampler), place = sampler_next(&sampler);
    struct light_ray ray;
    if (!light_ray_start(&tracer->emission, chunk->light, place, sample, &tracer->aim,
                         tracer->rays.clearance, &ray))
        return;
    ray.flux = glms_vec3_scale(ray.flux, 1 / (float)tracer->counts[chunk->light]);
    light_path_trace(&tracer->scene, &ray, &sampler, &chunk->deposits, &chunk->balance);
}

static void trace_chunk(void *context, size_t number) {
    struct light_tracer *tracer = context;
    struct chunk *chunk = &tracer->chunks[number];
    for (uint32_t i = 0; i < chunk->count; i++)
        trace_ray(tracer, chunk, chunk->first + i);
}

static void add_balance(struct light_balance *sum, const struct light_balance *part) {
    sum->emitted += part->emitted;
    sum->missed += part->missed;
    sum->landed += part->landed;
    sum->absorbed += part->absorbed;
    sum->escaped += part->escaped;
    sum->cut += part->cut;
}

/* Each batch sends all flux. */
static struct light_balance balance_of_batch(const struct light_tracer *tracer) {
    const struct light_balance *sum = &tracer->balance;
    double batches = tracer->batches > 0 ? tracer->batches : 1;
    return (struct light_balance){sum->emitted / batches, sum->missed / batches,
                                  sum->landed / batches,  sum->absorbed / batches,
                                  sum->escaped / batches, sum->cut / batches};
}

static void trace_wave(struct light_tracer *tracer, int count) {
    parallel_for((size_t)count, tracer->desc.threads, trace_chunk, tracer);
    for (int i = 0; i < count; i++) {
        struct chunk *chunk = &tracer->chunks[i];
        for (int k = 0; k < chunk->deposits.count; k++)
            light_film_add(&tracer->film, &chunk->deposits.items[k]);
        add_balance(&tracer->balance, &chunk->balance);
        chunk->deposits.count = 0;
        chunk->balance = (struct light_balance){0};
    }
}

static bool report(const struct light_tracer *tracer, double batch_done) {
    double done = (tracer->batch + batch_done) / tracer->batches;
    const struct light_tracer_desc *desc = &tracer->desc;
    return !desc->progress || desc->progress(desc->user, done) || error_set("cancelled");
}

static bool trace_batch(struct light_tracer *tracer) {
    int waiting = 0;
    double all = 0, done = 0;
    for (int n = 0; n < tracer->emission.count; n++)
        all += tracer->counts[n];
    for (int n = 0; n < tracer->emission.count; n++) {
        uint32_t count = (uint32_t)tracer->counts[n];
        for (uint32_t first = 0; first < count; first += CHUNK) {
            struct chunk *chunk = &tracer->chunks[waiting++];
            chunk->light = n;
            chunk->first = first;
            chunk->count = count - first < CHUNK ? count - first : CHUNK;
            done += chunk->count;
            if (waiting < WAVE)
                continue;
            trace_wave(tracer, waiting);
            waiting = 0;
            if (!report(tracer, done / all))
                return false;
        }
    }
    trace_wave(tracer, waiting);
    light_film_end_batch(&tracer->film);
    return report(tracer, 1);
}

static bool trace_all(struct light_tracer *tracer, const struct hit_table *table) {
    const struct light_tracer_desc *desc = &tracer->desc;
    int most = desc->paths / RAYS_PER_BATCH;
    tracer->batches = most < 1 ? 1 : most < BATCHES ? most : BATCHES;
    tracer->aim = desc->straight ? (struct light_aim){.radius = INFINITY} : light_aim_of(table);
    tracer->counts = mem_alloc((size_t)tracer->emission.count, sizeof *tracer->counts);
    for (int n = 0; n < tracer->emission.count; n++)
        tracer->counts[n] =
            light_ray_count(&tracer->emission, n, (double)desc->paths / tracer->batches);
    bool ok = true;
    for (tracer->batch = 0; ok && tracer->batch < tracer->batches; tracer->batch++)
        ok = trace_batch(tracer);
    free(tracer->counts);
    for (int i = 0; i < WAVE; i++)
        free(tracer->chunks[i].deposits.items);
    return ok;
}

static bool trace(struct light_tracer *tracer, const struct hit_table *table) {
    const struct light_tracer_desc *desc = &tracer->desc;
    if (!ray_scene_init(&tracer->rays, table))
        return false;
    struct primary_rays primary =
        primary_rays_of(&tracer->rays, desc->camera, desc->geometry, desc->width, desc->height);
    tracer->scene = (struct light_path_scene){
        .rays = &tracer->rays,
        .emission = &tracer->emission,
        .link = camera_link_of(&primary, desc->geometry->radius),
        .straight = desc->straight,
    };
    return trace_all(tracer, table);
}

bool light_tracer_render(const struct light_tracer_desc *desc, struct image *image,
                         struct light_tracer_result *result) {
    enum { RAYS_DEALT = 1 << 12 };
    struct hit_table table;
    assert(desc->paths > 0 && image->width == desc->width && image->height == desc->height);
    struct light_tracer *tracer = mem_alloc(1, sizeof *tracer);
    *result = (struct light_tracer_result){0};
    tracer->desc = *desc;
    hit_table_init(&table, desc->scene, desc->geometry, MATERIALS_FULL);
    result->has_smooth = hit_table_find_smooth(&table);
    emission_init(&tracer->emission, &desc->emitters, desc->geometry, &table, RAYS_DEALT);
    tracer->emission.medium = medium_ball_of(&desc->medium, desc->geometry);
    bool ok = light_film_init(&tracer->film, desc->width, desc->height);
    bool traces = ok && tracer->emission.count > 0 && (result->has_smooth || desc->straight);
    if (traces)
        ok = trace(tracer, &table);
    if (ok && !traces)
        light_film_end_batch(&tracer->film);
    if (ok)
        result->noise = light_film_develop(&tracer->film, medium_exists(&desc->medium), image);
    result->balance = balance_of_batch(tracer);
    light_film_free(&tracer->film);
    emission_free(&tracer->emission);
    ray_scene_free(&tracer->rays);
    free(tracer);
    return ok;
}
