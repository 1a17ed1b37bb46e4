#include "reference/light_vertices.h"

#include "base/memory.h"
#include "base/parallel.h"

struct work {
    const struct emission *emission;
    const struct ray_scene *rays;
    uint32_t seed;
    struct light_vertices vertices;
};

enum { CHUNK = 1 << 10 };

/* Each light has points of its own. */
static uint32_t seed_of(const struct work *work, int light) {
    return light ? sampler_hash(work->seed, (uint32_t)light) : work->seed;
}

static void trace(const struct work *work, uint32_t i) {
    struct dealt ray = work->emission->rays[i];
    struct sampler sampler = {.seed = seed_of(work, ray.taker), .index = (uint32_t)ray.number};
    struct light_vertex *vertex = &work->vertices.items[i];
    struct arrival arrival;
    struct hit hit;
    vec2s sample = sampler_next(&sampler), place = sampler_next(&sampler);
    if (!emission_first_hit(work->emission, ray.taker, work->rays, place, sample, &hit) ||
        !emission_reach(work->emission, ray.taker, place, &hit, &arrival))
        return;
    arrival.irradiance = glms_vec3_mul(arrival.irradiance, hit.share);
    vertex->position = hit.position;
    vertex->normal = hit.geometric_normal;
    vertex->diffuse = hit.brdf.diffuse;
    if (vertex->diffuse) {
        vertex->radiance = emission_reflected(&hit, &arrival);
        vertex->found = arrival.found;
    } else {
        work->vertices.specular[i] = (struct light_specular){hit, arrival};
    }
    if (!vertex->diffuse || glms_vec3_norm2(vertex->radiance) > 0)
        vertex->density = arrival.density;
    vertex->chosen = emission_times_chosen(work->emission, &hit, LIGHT_CHOICES, ray.taker, place);
}

static void trace_chunk(void *context, size_t chunk) {
    for (uint32_t i = 0; i < CHUNK; i++)
        trace(context, (uint32_t)chunk * CHUNK + i);
}

struct light_vertices light_vertices_trace(const struct emission *emission,
                                           const struct ray_scene *rays, uint32_t seed,
                                           int threads) {
    struct work work = {.emission = emission, .rays = rays, .seed = seed};
    work.vertices.items = mem_alloc(LIGHT_VERTEX_COUNT, sizeof *work.vertices.items);
    if (rays->table->has_specular)
        work.vertices.specular = mem_alloc(LIGHT_VERTEX_COUNT, sizeof *work.vertices.specular);
    if (emission->count > 0)
        parallel_for(LIGHT_VERTEX_COUNT / CHUNK, threads, trace_chunk, &work);
    return work.vertices;
}

void light_vertices_free(struct light_vertices *vertices) {
    mem_free(vertices->items, vertices->specular);
    *vertices = (struct light_vertices){0};
}
