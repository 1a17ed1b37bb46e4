/* scene.xml of Mitsuba 3, for its variants of RGB, with its meshes and textures.
 *
 * Exact: triangles, camera, diffuse surfaces without a mask, points, area lights, meshes that shine
 * on one side, the environment's turn. Notes name all that is not. */
#ifndef LAB_EXPORT_MITSUBA_H
#define LAB_EXPORT_MITSUBA_H

#include "lab/export/target.h"

bool export_mitsuba(struct export_target *target);

#endif
