#include "scene/hash.h"

#include "scene/lights/environment.h"

#include <stddef.h>
#include <string.h>

void hash_bytes(uint64_t *sum, const void *bytes, size_t size) {
    for (const unsigned char *b = bytes; size; b++, size--)
        *sum = (*sum ^ *b) * 0x100000001b3U;
}

/* Where its textures lie, of a material that has more than one mapping; and whose they are. */
static void hash_mappings(uint64_t *sum, const struct material *m) {
    const int own[] = {m->metal_roughness_mapping, m->emission_mapping, m->normal_mapping,
                       m->specular_glossiness};
    static const int plain[sizeof own / sizeof *own];
    if (memcmp(own, plain, sizeof own) != 0)
        hash_bytes(sum, own, sizeof own);
}

/* Of a material that lets light pass. */
static void hash_passing(uint64_t *sum, const struct material *m) {
    const float own[] = {m->blends, m->thickness};
    if (m->blends || m->thickness > 0)
        hash_bytes(sum, own, sizeof own);
}

static void hash_materials(uint64_t *sum, const struct scene *scene) {
    for (int i = 0; i < scene->material_count; i++) {
        const struct material *m = &scene->materials[i];
        const size_t from = offsetof(struct material, base_color);
        hash_bytes(sum, m->base_color,
                   offsetof(struct material, alpha_mask) - from); /* no padding */
        hash_bytes(sum, &m->alpha_mask, sizeof m->alpha_mask);
        hash_bytes(sum, &m->alpha_cutoff, sizeof m->alpha_cutoff);
        hash_bytes(sum, &m->double_sided, sizeof m->double_sided);
        hash_mappings(sum, m);
        hash_passing(sum, m);
    }
    for (int i = 0; i < scene->texture_count; i++) {
        const struct scene_texture *t = &scene->textures[i];
        hash_bytes(sum, t->bitmap.rgba, 4 * (size_t)t->bitmap.width * (size_t)t->bitmap.height);
        hash_bytes(sum, &t->linear, sizeof t->linear);
        hash_bytes(sum, &t->wrap_u, sizeof t->wrap_u);
        hash_bytes(sum, &t->wrap_v, sizeof t->wrap_v);
        hash_bytes(sum, &t->nearest, sizeof t->nearest);
    }
}

static void hash_geometry(uint64_t *sum, const struct geometry *g) {
    size_t vertices = g->vertex_count;
    hash_bytes(sum, g->position, vertices * sizeof *g->position);
    hash_bytes(sum, g->normal, vertices * sizeof *g->normal);
    for (int m = 0; m < g->mapping_count; m++)
        hash_bytes(sum, g->uv[m], vertices * sizeof *g->uv[m]);
    for (uint32_t i = 0; i < vertices; i++)
        hash_bytes(sum, geometry_color(g, i), sizeof *g->color);
    hash_bytes(sum, g->indices, g->index_count * sizeof *g->indices);
    for (int i = 0; i < g->batch_count; i++) {
        hash_bytes(sum, &g->batches[i].material, sizeof g->batches[i].material);
        hash_bytes(sum, &g->batches[i].index_count, sizeof g->batches[i].index_count);
    }
}

static void hash_environment(uint64_t *sum, const struct environment *sky) {
    size_t texels = (size_t)sky->width * (size_t)sky->height;
    hash_bytes(sum, sky->texels, texels * sizeof *sky->texels);
    hash_bytes(sum, &sky->turn, sizeof sky->turn);
    hash_bytes(sum, &sky->strength, sizeof sky->strength);
}

uint64_t scene_hash(const struct scene *scene, const struct geometry *geometry,
                    const struct camera *camera, const struct emitters *emitters) {
    uint64_t sum = 0xcbf29ce484222325U;
    hash_materials(&sum, scene);
    hash_geometry(&sum, geometry);
    hash_bytes(&sum, &camera->orthographic, sizeof camera->orthographic);
    hash_bytes(&sum, camera->eye, offsetof(struct camera, shift) - offsetof(struct camera, eye));
    if (camera->shift[0] != 0 || camera->shift[1] != 0)
        hash_bytes(&sum, camera->shift, sizeof camera->shift);
    hash_bytes(&sum, emitters->items, (size_t)emitters->count * sizeof *emitters->items);
    if (emitters->sky)
        hash_environment(&sum, emitters->sky);
    return sum;
}
