#include "techniques/implicit-visibility/lamps.h"

#include "base/memory.h"
#include "scene/lights/emissive.h"

static void find_elements(struct lamps *lamps, const struct scene *scene,
                          const struct geometry *geometry, const struct elements *elements) {
    int *of_vertices = mem_alloc(geometry->vertex_count, sizeof *of_vertices);
    for (int s = 0; s < scene->surface_count; s++) {
        struct emissive_span span = emissive_find(geometry, &scene->surfaces[s]);
        for (uint32_t i = 3 * span.first; i < 3 * span.end; i++)
            of_vertices[geometry->indices[i]] = scene->surfaces[s].lamp;
    }
    for (int i = 0; i < elements->count; i++)
        lamps->of_elements[i] = of_vertices[elements->items[i].corners[0]];
    free(of_vertices);
}

static void add_up(double (*sums)[3], int count, const struct emitters *emitters) {
    for (int i = 0; i < emitters->count; i++) {
        const struct emitter *light = &emitters->items[i];
        if (light->lamp <= 0 || light->lamp >= count)
            continue;
        for (int c = 0; c < 3; c++) {
            sums[0][c] += (double)light->intensity[c];
            sums[light->lamp][c] += (double)light->intensity[c];
        }
    }
}

void lamps_init(struct lamps *lamps, const struct scene *scene, const struct geometry *geometry,
                const struct elements *elements) {
    struct emitters emitters = emitters_place(scene, 0);
    *lamps = (struct lamps){.count = 1};
    for (int i = 0; i < scene->surface_count; i++)
        if (scene->surfaces[i].lamp >= lamps->count)
            lamps->count = scene->surfaces[i].lamp + 1;
    lamps->own = mem_alloc((size_t)lamps->count, sizeof *lamps->own);
    lamps->share = mem_alloc((size_t)lamps->count, sizeof *lamps->share);
    lamps->of_elements = mem_alloc((size_t)elements->count, sizeof *lamps->of_elements);
    add_up(lamps->own, lamps->count, &emitters);
    find_elements(lamps, scene, geometry, elements);
    emitters_free(&emitters);
}

void lamps_free(struct lamps *lamps) {
    mem_free(lamps->own, lamps->share, lamps->of_elements);
    *lamps = (struct lamps){0};
}

void lamps_follow(struct lamps *lamps, const struct emitters *emitters) {
    double(*sums)[3] = mem_alloc((size_t)lamps->count, sizeof *sums);
    add_up(sums, lamps->count, emitters);
    for (int l = 0; l < lamps->count; l++)
        for (int c = 0; c < 3; c++)
            lamps->share[l][c] = lamps->own[l][c] > 0 ? (float)(sums[l][c] / lamps->own[l][c]) : 0;
    free(sums);
}
