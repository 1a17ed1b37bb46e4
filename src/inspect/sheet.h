/* All layers of a buffer at once: cells of one shape in rows, the first at the top left. */
#ifndef INSPECT_SHEET_H
#define INSPECT_SHEET_H

struct sheet {
    int layers, columns, rows;
    int cell_width, cell_height; /* with the gaps, pixels */
};

/* As many columns as make cells of that shape, width over height, largest in the room. */
struct sheet sheet_fit(int width, int height, int layers, float aspect);

/* Which layer lies at a place of the sheet (0 to 1, y down); -1 = none. */
int sheet_layer_at(const struct sheet *sheet, float x, float y);

#endif
