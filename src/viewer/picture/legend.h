/* What the cells of a sheet and the colours of a VAL's shadow stand for. */
#ifndef VIEWER_LEGEND_H
#define VIEWER_LEGEND_H

#include "viewer/state.h"

/* What it takes below a sheet of VALs; 0 = nothing: on a single one it stands. */
float legend_height(const struct viewer *viewer);
void legend_draw(const struct viewer *viewer);

#endif
