/* passes/picture/planes.h to its shaders, and to those that read what it finds. */
#ifndef SHARED_PLANES_H
#define SHARED_PLANES_H

#include "shared/types.h"

#define PLANE_BLOCK 4 /* pixels a side */

#endif
