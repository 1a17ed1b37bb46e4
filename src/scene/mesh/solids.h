/* Which sides of surfaces lie within something, where no light comes: half of what a hall's walls, columns and vases
 * have as area, where files call all surfaces double-sided.
 *
 * Told by what a few rays from there meet. Within a solid they meet the backs of its surfaces, as these are wound; a
 * curtain's back sees the fronts of what hangs opposite. What sees no surface passes light to none either: the outside
 * of a house, the bottom of what stands on a floor. Backs that reflect nothing count for nothing. Windings say all of
 * this, so that a scene whose cameras see more backs than fronts is wound otherwise, and nothing in it is hidden.
 *
 * Only what never moves, whatever clip plays, hides or is hidden, and no alpha masks hide: the answer belongs to the
 * scene, not to a time of it.
 */
#ifndef SCENE_MESH_SOLIDS_H
#define SCENE_MESH_SOLIDS_H

#include "scene/mesh/geometry.h"
#include "scene/mesh/triangle_tree.h"

struct solids {
    struct triangle_tree tree; /* of what never moves; without triangles: nothing is hidden */
    bool *moves;               /* of each node */
    float clearance;           /* rays begin so far above a surface, metres */
};

void solids_init(struct solids *solids, const struct scene *scene, const struct geometry *geometry);

/* Accepts zeroed ones. */
void solids_free(struct solids *solids);

/* Whether a point of that part, on the side of a unit normal, is hidden. The number turns the rays. Thread-safe. */
bool solids_hide(const struct solids *solids, const struct geometry_part *part, vec3s position,
                 vec3s normal, uint32_t number);

#endif
