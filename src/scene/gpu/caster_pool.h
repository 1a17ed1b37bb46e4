/* Shares the casters of one geometry by their description.
 *
 * Simplifying a large scene takes seconds, so users with equal descriptions share a caster. The
 * last unused one is kept until another is acquired. Rebuilt users, and users that alternate
 * between two descriptions, find theirs again. */
#ifndef SCENE_GPU_CASTER_POOL_H
#define SCENE_GPU_CASTER_POOL_H

#include "scene/gpu/caster_gpu.h"
#include "scene/gpu/caster_bvh.h"
#include "scene/mesh/levels.h"

struct caster_pool;

/* Scene and geometry must outlive the pool. */
struct caster_pool *caster_pool_create(const struct scene *scene, const struct geometry *geometry);

/* Returns the levels of detail that casters start from, made at the first call. */
struct levels *caster_pool_levels(struct caster_pool *pool);

/* True above 2^20 triangles. */
bool caster_pool_is_large(const struct geometry *geometry);

/* Requires that all casters are released. Accepts NULL. */
void caster_pool_free(struct caster_pool *pool);

/* True if the pool holds a caster of this description, in any pose. */
bool caster_pool_has(const struct caster_pool *pool, const struct caster_desc *desc);

/* Returns a caster, built in the pose at its first acquisition and moved to the current one. With
 * an error bound and a static scene, the eye is the scene's first camera, whatever desc.eye is.
 * Exact casters have none: near a map's centre fronts are left out, and only backs block. Error:
 * out of GPU memory. */
bool caster_pool_acquire(struct caster_pool *pool, const struct caster_gpu **caster,
                         const struct caster_desc *desc);

/* Accepts a pointer to NULL. */
void caster_pool_release(struct caster_pool *pool, const struct caster_gpu **caster);

/* Returns the shared BVH for rays. Error: that of caster_bvh_update. */
bool caster_pool_acquire_tree(struct caster_pool *pool, const struct caster_bvh **tree);

/* Returns the BVH on the CPU if it holds all triangles in this pose, without panes and mask cuts;
 * else NULL. */
const struct bvh *caster_pool_built(const struct caster_pool *pool,
                                    const struct geometry *geometry);

/* Accepts a pointer to NULL, of any pool. */
void caster_pool_release_tree(struct caster_pool *pool, const struct caster_bvh **tree);

/* Moves the casters in use; call it after geometry_pose. Error: out of GPU memory; the caller must
 * then free the pool. */
bool caster_pool_update(struct caster_pool *pool);

#endif
