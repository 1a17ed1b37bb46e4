#include "inspect/sheet.h"

#include <math.h>
#include <stdbool.h>

struct sheet sheet_fit(int width, int height, int layers, float aspect) {
    struct sheet best = {layers, 1, layers, 1, 1};
    for (int columns = 1; columns <= layers; columns++) {
        int rows = (layers + columns - 1) / columns;
        float across = (float)width / (float)columns, down = (float)height / (float)rows;
        int cell_height = (int)fminf(across / aspect, down);
        if (cell_height > best.cell_height)
            best = (struct sheet){layers, columns, rows, (int)((float)cell_height * aspect),
                                  cell_height};
    }
    return best;
}

int sheet_layer_at(const struct sheet *sheet, float x, float y) {
    int column = (int)(x * (float)sheet->columns), row = (int)(y * (float)sheet->rows);
    int layer = row * sheet->columns + column;
    bool inside = x >= 0 && y >= 0 && column < sheet->columns && row < sheet->rows;
    return inside && layer < sheet->layers ? layer : -1;
}
