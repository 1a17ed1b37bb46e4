/* passes/visibility/block_visibility.h to its shader. */
#ifndef SHARED_BLOCK_VISIBILITY_H
#define SHARED_BLOCK_VISIBILITY_H

#include "shared/types.h"

struct block_visibility_params {
    int block; /* pixels a side */
    int unused0, unused1, unused2;
};
PASS_BLOCK(block_visibility_params, 16)

#endif
