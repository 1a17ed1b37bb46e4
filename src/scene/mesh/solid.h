/* Finds triangles whose backs are inside solids, like walls or table legs. Views from the open may
 * skip their back faces.
 *
 * Files seldom close a solid: columns stand open on the floor, and walls end at the next wall. So
 * rays decide. Inside a solid a ray meets backs, or fronts from which most rays again meet backs. A
 * ray that escapes, or meets a front in the open, shows that the back may be visible. A sheet is no
 * solid: rays from its back meet the room. Few rays may miss a thin gap. */
#ifndef SCENE_MESH_SOLID_H
#define SCENE_MESH_SOLID_H

#include <stdbool.h>
#include <stdint.h>

/* Front faces are counter-clockwise. */
struct solid_mesh {
    float (*position)[3];
    const uint32_t *indices;
    uint32_t triangle_count;
    float clearance; /* offset of ray origins above surfaces, metres */
};

/* Sets within[i] if the back of triangle i is inside. eye: a point in the open. If the eye sees
 * more than a few of these backs, as in a room modelled from outside, none counts as inside. It
 * runs on all cores; the result does not depend on their number. */
void solid_find(bool *within, const struct solid_mesh *mesh, const float eye[3]);

#endif
