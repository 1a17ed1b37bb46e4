/* Parameters of techniques/implicit-visibility/interpolate.h: surface elements, sorted into grid
 * cells. */
#ifndef SHARED_ELEMENT_GRID_H
#define SHARED_ELEMENT_GRID_H

#include "shared/types.h"

/* STORAGE_ELEMENT_CELLS: for each cell the first element in it or in a later one; x counts fastest.
 * STORAGE_ELEMENTS, texels of an element: position and weight; normal, and 1 for a pane's element;
 * irradiance and element number. */
#define ELEMENT_TEXELS 3

struct element_grid_params {
    vec3 low;                      /* corner of the first cell, metres */
    float cell;                    /* side of a cell, and reach of elements, metres */
    int cells_x, cells_y, cells_z; /* cells along each axis; the outermost are empty */
    float scale;                   /* factor of the result */
};
PASS_BLOCK(element_grid_params, 32)

#endif
