/* Draws the legend of a sheet's cells and of the colours of a VAL's shadow. */
#ifndef VIEWER_LEGEND_H
#define VIEWER_LEGEND_H

#include "viewer/state.h"

/* Returns its height below a sheet of VALs, pixels. 0 for a single VAL: the legend lies on the
 * picture. */
float legend_height(const struct viewer *viewer);

/* Draws the scale of a map of values at the left, from y on, with the unit after its greatest. */
void legend_draw_scale(const struct viewer *viewer, const struct heat_map *scale, const char *unit,
                       float y);

void legend_draw(const struct viewer *viewer);

#endif
