/* inspect/screen.h to its shader. */
#ifndef SHARED_SCREEN_H
#define SHARED_SCREEN_H

#include "shared/types.h"

#define UNIT_LEFT_PICTURE (UNIT_OWN + 0)
#define UNIT_RIGHT_PICTURE (UNIT_OWN + 1)

struct screen_params {
    vec2 corner, size; /* of the picture in the window, pixels */
    float split;       /* where the right picture begins, over the width */
    float difference;  /* 1: of the two, in place of them */
    float unused0, unused1;
};
PASS_BLOCK(screen_params, 32)

#endif
