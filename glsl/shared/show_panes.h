/* Parameters of passes/picture/show_panes.h. */
#ifndef SHARED_SHOW_PANES_H
#define SHARED_SHOW_PANES_H

#include "shared/types.h"

#define PANE_LAYERS 8                         /* most visible panes of a pixel */
#define UNIT_BEHIND_IN_SCATTER (UNIT_OWN + 0) /* of the medium; also the next */
#define UNIT_BEHIND_TRANSMITTANCE (UNIT_OWN + 1)
#define UNIT_PANES_SKY (UNIT_OWN + 2)

struct show_panes_params {
    float scale; /* stored = radiance times this */
    float sky_strength, sky_turn;
    float unused;
};
PASS_BLOCK(show_panes_params, 16)

#endif
