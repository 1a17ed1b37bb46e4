/* Lays out all layers of a buffer in rows of equal cells, the first at the top left. */
#ifndef INSPECT_SHEET_H
#define INSPECT_SHEET_H

struct sheet {
    int layers, columns, rows;
    int cell_width, cell_height; /* pixels, gaps included */
};

/* Chooses the number of columns with the largest cells of aspect ratio width over height. */
struct sheet sheet_fit(int width, int height, int layers, float aspect);

/* Returns the layer at a point of the sheet, in [0, 1]^2, y down; -1: none. */
int sheet_layer_at(const struct sheet *sheet, float x, float y);

#endif
