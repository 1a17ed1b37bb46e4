/* scene.pbrt of pbrt-v4, with its meshes and textures.
 *
 * Exact: triangles, camera, diffuse surfaces of double-sided materials, points, area lights, meshes that shine in one
 * colour. pbrt computes with spectra, so that colours of several reflections differ. Notes name all else. */
#ifndef APPS_EXPORT_PBRT_H
#define APPS_EXPORT_PBRT_H

#include "apps/export/target.h"

bool export_pbrt(struct export_target *target);

#endif
