/* passes/gather/vpl_cut.h to its shader. */
#ifndef SHARED_VPL_CUT_H
#define SHARED_VPL_CUT_H

#include "shared/types.h"

#define CUT_GROUP 8      /* invocations a side */
#define CUT_NODES_MAX 64 /* of a block's cut */

struct vpl_cut_params {
    ivec2 blocks; /* of the picture */
    int block;    /* pixels a side */
    int leaves;   /* of the tree */
    int nodes;    /* of a cut, at most */
    int more_nodes; /* the same of a further one of each block */
    float tolerance;
    float clamp_at; /* as in gather_params */
};
STD140_SIZE(vpl_cut_params, 32)

#endif
