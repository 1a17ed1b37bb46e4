/* Triangles whose backs are the inside of something solid, a wall or a table's leg, which nobody in the open sees: what
 * looks from there may leave out those that are turned away.
 *
 * Files seldom close a solid: a column stands open on the floor, a wall ends where the next begins. So rays ask. From a
 * back within a solid they meet other backs, or a front that lies within, too, as the floor below the column does: most
 * rays from there meet backs again. One that gets away, or meets a front in the open, tells that the back may be seen.
 * A sheet is no solid: rays from its back meet the room. What a thin gap alone leads to may be missed, as rays are few.
 */
#ifndef SCENE_MESH_SOLID_H
#define SCENE_MESH_SOLID_H

#include <stdbool.h>
#include <stdint.h>

/* The front of a triangle is where its corners go counter-clockwise. */
struct solid_mesh {
    float (*position)[3];
    const uint32_t *indices;
    uint32_t triangle_count;
    float clearance; /* rays begin so far above a surface, metres */
};

/* For each triangle whether its back lies within. eye: a place in the open. A room may be modelled from without, so
 * that all its backs are seen: where the eye sees more than a few that would lie within, none does. On all cores; the
 * same for any number of them. */
void solid_find(bool *within, const struct solid_mesh *mesh, const float eye[3]);

#endif
