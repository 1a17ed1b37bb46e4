#include "scene/gpu/caster_pool.h"

#include "base/clock.h"
#include "base/memory.h"
#include "base/phases.h"
#include "scene/camera.h"
#include "scene/node.h"

#include <assert.h>
#include <stdlib.h>

struct caster_pool {
    const struct scene *scene;
    const struct geometry *geometry;
    struct pooled {
        struct caster_gpu gpu;
        struct caster_desc desc;
        vec3 eye; /* that tells what is solid; zeros: none */
        int uses;
        struct pooled *next;
    } * first;
    struct caster_bvh tree;
    int tree_uses;
    struct levels levels;
    bool has_levels;
};

struct caster_pool *caster_pool_create(const struct scene *scene, const struct geometry *geometry) {
    struct caster_pool *pool = mem_alloc(1, sizeof *pool);
    pool->scene = scene;
    pool->geometry = geometry;
    return pool;
}

/* Small scenes have no levels, and the casters of each part are made by themselves. */
bool caster_pool_is_large(const struct geometry *geometry) {
    return geometry->index_count / 3 > 1 << 20;
}

struct levels *caster_pool_levels(struct caster_pool *pool) {
    double start = clock_ms();
    if (!pool->has_levels && caster_pool_is_large(pool->geometry))
        levels_init(&pool->levels, pool->scene, pool->geometry);
    phase_add(PHASE_SIMPLIFY, start);
    pool->has_levels = true;
    return &pool->levels;
}

static void free_unused(struct caster_pool *pool) {
    for (struct pooled **link = &pool->first; *link;) {
        struct pooled *pooled = *link;
        if (pooled->uses) {
            link = &pooled->next;
            continue;
        }
        *link = pooled->next;
        caster_gpu_free(&pooled->gpu);
        free(pooled);
    }
}

void caster_pool_free(struct caster_pool *pool) {
    if (pool) {
        free_unused(pool);
        caster_bvh_free(&pool->tree);
        levels_free(&pool->levels);
        assert(!pool->first && !pool->tree_uses);
    }
    free(pool);
}

static struct pooled *find(const struct caster_pool *pool, const struct caster_desc *desc) {
    struct pooled *pooled = pool->first;
    while (pooled &&
           (pooled->desc.error != desc->error || pooled->desc.long_count != desc->long_count))
        pooled = pooled->next;
    return pooled;
}

bool caster_pool_has(const struct caster_pool *pool, const struct caster_desc *desc) {
    return find(pool, desc);
}

/* Nothing moves, whatever clip plays, and a camera stands in the open; what stands in for a scene
 * has none. */
static bool tells_solids(const struct scene *scene) {
    return scene->clip_count == 0 && scene->metaballs_count == 0 &&
           node_count_carrying(scene, NODE_CAMERA) > 0;
}

/* Returns true and the eye that tells what is solid; false and zeros if none does. */
static bool find_eye(const struct caster_pool *pool, const struct caster_desc *desc, vec3 eye) {
    struct camera camera = {0};
    bool found = desc->error > 0 && tells_solids(pool->scene);
    if (found)
        camera_place(&camera, pool->scene, 0, 0);
    glm_vec3_copy(camera.eye, eye);
    return found;
}

static bool fill(const struct caster_pool *pool, struct pooled *pooled) {
    struct caster_desc own = pooled->desc;
    own.scene = caster_pool_is_large(pool->geometry) ? pool->scene : NULL;
    own.levels = pool->has_levels ? &pool->levels : NULL;
    if (find_eye(pool, &own, pooled->eye))
        own.eye = pooled->eye;
    return caster_gpu_init(&pooled->gpu, pool->geometry, &own);
}

static struct pooled *add(struct caster_pool *pool, const struct caster_desc *desc) {
    struct pooled *pooled = mem_alloc(1, sizeof *pooled);
    free_unused(pool);
    pooled->desc = *desc;
    if (!fill(pool, pooled)) {
        free(pooled);
        return NULL;
    }
    pooled->next = pool->first;
    return pool->first = pooled;
}

/* A changed geometry is simplified anew, and one that is seen from another eye. */
static bool update(const struct caster_pool *pool, struct pooled *pooled) {
    vec3 eye;
    find_eye(pool, &pooled->desc, eye);
    if (pooled->gpu.pose >= pool->geometry->changed && glm_vec3_eqv(eye, pooled->eye))
        return caster_gpu_update(&pooled->gpu, pool->geometry);
    caster_gpu_free(&pooled->gpu);
    return fill(pool, pooled);
}

bool caster_pool_acquire(struct caster_pool *pool, const struct caster_gpu **caster,
                         const struct caster_desc *desc) {
    struct pooled *pooled = find(pool, desc);
    *caster = NULL;
    if (!pooled)
        pooled = add(pool, desc);
    else if (!pooled->uses && !update(pool, pooled)) {
        free_unused(pool);
        pooled = NULL;
    }
    if (!pooled)
        return false;
    pooled->uses++;
    *caster = &pooled->gpu;
    return true;
}

void caster_pool_release(struct caster_pool *pool, const struct caster_gpu **caster) {
    if (!*caster)
        return;
    struct pooled *pooled = pool->first;
    while (&pooled->gpu != *caster)
        pooled = pooled->next;
    assert(pooled->uses > 0);
    if (pooled->uses == 1)
        free_unused(pool); /* this one takes its place */
    pooled->uses--;
    *caster = NULL;
}

bool caster_pool_acquire_tree(struct caster_pool *pool, const struct caster_bvh **tree) {
    *tree = NULL;
    if (!caster_bvh_update(&pool->tree, pool->scene, pool->geometry)) {
        caster_bvh_free(&pool->tree);
        return false;
    }
    pool->tree_uses++;
    *tree = &pool->tree;
    return true;
}

const struct bvh *caster_pool_built(const struct caster_pool *pool,
                                    const struct geometry *geometry) {
    bool is_it = pool->geometry == geometry && pool->tree.pose == geometry->pose_count &&
                 geometry->opaque_index_count == geometry->blocking_index_count;
    return is_it && pool->tree.built.nodes ? &pool->tree.built : NULL;
}

void caster_pool_release_tree(struct caster_pool *pool, const struct caster_bvh **tree) {
    if (!*tree)
        return;
    assert(pool->tree_uses > 0);
    pool->tree_uses--;
    *tree = NULL;
}

bool caster_pool_update(struct caster_pool *pool) {
    for (struct pooled *pooled = pool->first; pooled; pooled = pooled->next)
        if (pooled->uses && !update(pool, pooled))
            return false;
    return !pool->tree_uses || caster_bvh_update(&pool->tree, pool->scene, pool->geometry);
}
