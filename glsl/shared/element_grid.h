/* techniques/implicit-visibility/interpolate.h to its shader: surface elements, sorted into cells of a grid. */
#ifndef SHARED_ELEMENT_GRID_H
#define SHARED_ELEMENT_GRID_H

#include "shared/types.h"

/* STORAGE_ELEMENT_CELLS: of each cell the number of the first element that lies in it or in a later one; x counts fastest.
 * STORAGE_ELEMENTS: texels of each element: position and weight; normal, and 1 if a pane's; irradiance and the
 * element's number. */
#define ELEMENT_TEXELS 3

struct element_grid_params {
    vec3 low;     /* corner of the first cell, metres */
    float cell;   /* side of a cell, and how far elements reach, metres */
    int cells_x, cells_y, cells_z; /* along each axis; the outermost are empty */
    float scale;  /* of the result */
};
PASS_BLOCK(element_grid_params, 32)

#endif
