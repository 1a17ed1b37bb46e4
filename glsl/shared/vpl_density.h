/* The density of VPLs over each light's domain (lib/light_domain.glsl), as an importance map has it
 * (passes/lights/importance_map.h). */
#ifndef SHARED_VPL_DENSITY_H
#define SHARED_VPL_DENSITY_H

#include "shared/types.h"

/* Cells along each side of a light's domain, and mip levels from a cell to the whole domain. */
#define VPL_DENSITY_SIDE 64
#define VPL_DENSITY_LEVELS 7
#define VPL_DENSITY_ROW 8 /* the lights' domains are tiles of one texture, so many in a row */

#endif
