/* The casters of one geometry, by what they are made for.
 *
 * Simplifying a large scene takes seconds. So whoever asks for a caster that is there
 * already shares it, and of those that nobody uses the last one stays until another is asked for:
 * what is made anew with the same casters, and what goes back and forth between two, finds them.
 */
#ifndef SCENE_GPU_CASTER_POOL_H
#define SCENE_GPU_CASTER_POOL_H

#include "scene/gpu/caster_gpu.h"
#include "scene/gpu/caster_bvh.h"

struct caster_pool;

/* Scene and geometry must outlive the pool. */
struct caster_pool *caster_pool_create(const struct scene *scene, const struct geometry *geometry);

/* All casters have been released. Accepts NULL. */
void caster_pool_free(struct caster_pool *pool);

/* Whether to acquire such a caster makes none, be the geometry posed as it may. */
bool caster_pool_has(const struct caster_pool *pool, const struct caster_desc *desc);

/* The caster is that of the pose in which it was first acquired, moved to the present one. Of one that may
 * stray, where nothing ever moves, the eye is the scene's first camera, whatever desc has; exact casters have none: near
 * a map's centre fronts are left out, and backs are all that blocks. Error: out of GPU memory. */
bool caster_pool_acquire(struct caster_pool *pool, const struct caster_gpu **caster,
                         const struct caster_desc *desc);

/* Accepts a pointer to NULL. */
void caster_pool_release(struct caster_pool *pool, const struct caster_gpu **caster);

/* The same with the tree for rays, of which there is one. Error: caster_bvh_update's. */
bool caster_pool_acquire_tree(struct caster_pool *pool, const struct caster_bvh **tree);

/* Accepts a pointer to NULL, of any pool. */
void caster_pool_release_tree(struct caster_pool *pool, const struct caster_bvh **tree);

/* After geometry_pose: moves the casters that are in use. Error: out of GPU memory; the pool
 * must then be freed. */
bool caster_pool_update(struct caster_pool *pool);

#endif
