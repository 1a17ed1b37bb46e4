#include "scene/gpu/hole_colors.h"

#include "base/memory.h"

#include <stdlib.h>
#include <string.h>

/* Mean colour of the opaque texels below, and how many there are. */
struct cell {
    float color[3], opaque;
};

struct level {
    struct cell *cells;
    int width, height;
};

static void add_cell(struct cell *to, const struct cell *from) {
    for (int c = 0; c < 3; c++)
        to->color[c] += from->color[c] * from->opaque;
    to->opaque += from->opaque;
}

static struct level half_of(const struct level *fine) {
    struct level half = {.width = (fine->width + 1) / 2, .height = (fine->height + 1) / 2};
    half.cells = mem_alloc((size_t)half.width * (size_t)half.height, sizeof *half.cells);
    for (int y = 0; y < fine->height; y++)
        for (int x = 0; x < fine->width; x++)
            add_cell(&half.cells[y / 2 * half.width + x / 2], &fine->cells[y * fine->width + x]);
    for (int i = 0; i < half.width * half.height; i++)
        for (int c = 0; c < 3 && half.cells[i].opaque > 0; c++)
            half.cells[i].color[c] /= half.cells[i].opaque;
    return half;
}

/* From the coarse level down, so that a hole takes the nearest mean there is. */
static void fill_level(const struct level *fine) {
    if (fine->width == 1 && fine->height == 1)
        return;
    struct level half = half_of(fine);
    fill_level(&half);
    for (int y = 0; y < fine->height; y++)
        for (int x = 0; x < fine->width; x++) {
            struct cell *cell = &fine->cells[y * fine->width + x];
            const struct cell *above = &half.cells[y / 2 * half.width + x / 2];
            if (cell->opaque <= 0)
                memcpy(cell->color, above->color, sizeof cell->color);
        }
    free(half.cells);
}

unsigned char *hole_colors_fill(const struct bitmap *bitmap, float cutoff) {
    struct level level = {.width = bitmap->width, .height = bitmap->height};
    size_t count = (size_t)level.width * (size_t)level.height;
    unsigned char *filled = mem_alloc(count, 4);
    level.cells = mem_alloc(count, sizeof *level.cells);
    memcpy(filled, bitmap->rgba, 4 * count);
    for (size_t i = 0; i < count; i++) {
        level.cells[i].opaque = (float)filled[4 * i + 3] >= 255 * cutoff;
        for (int c = 0; c < 3; c++)
            level.cells[i].color[c] = filled[4 * i + (size_t)c];
    }
    fill_level(&level);
    for (size_t i = 0; i < count; i++)
        for (int c = 0; c < 3 && level.cells[i].opaque <= 0; c++)
            filled[4 * i + (size_t)c] = (unsigned char)(level.cells[i].color[c] + .5F);
    free(level.cells);
    return filled;
}
