/* passes/visibility/basis.h to its shader. */
#ifndef SHARED_BASIS_H
#define SHARED_BASIS_H

#include "shared/types.h"

struct basis_params {
    int first_term; /* 4 g for group g */
    int unused0, unused1, unused2;
};
PASS_BLOCK(basis_params, 16)

#endif
