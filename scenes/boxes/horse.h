/* A horse that lifts a foreleg, as a soft body. */
#ifndef SCENES_HORSE_H
#define SCENES_HORSE_H

#include "shapes/soft_body.h"

/* Metres: 1.6 high at the withers; looks along +x, stands on y = 0. The body is emptied first. */
void shape_horse(struct soft_body *horse);

#endif
