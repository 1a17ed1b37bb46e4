#include "techniques/implicit-visibility/bins.h"

#include "base/memory.h"

#include <math.h>

static int major_axis(const float d[3]) {
    float x = fabsf(d[0]), y = fabsf(d[1]), z = fabsf(d[2]);
    return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
}

static int cell_of(const struct bins *bins, float coordinate) {
    float cell = (coordinate + 1) * .5F * (float)bins->side; /* far outside where a disk is near */
    return !(cell > 0) ? 0 : cell < (float)bins->side ? (int)cell : bins->side - 1;
}

int bins_face(const float direction[3]) {
    int axis = major_axis(direction);
    return 2 * axis + (direction[axis] < 0);
}

int bins_find(const struct bins *bins, const float direction[3]) {
    int axis = major_axis(direction);
    float inverse = 1 / fabsf(direction[axis]);
    int column = cell_of(bins, direction[(axis + 1) % 3] * inverse);
    int row = cell_of(bins, direction[(axis + 2) % 3] * inverse);
    int face = 2 * axis + (direction[axis] < 0);
    return (face * bins->side + row) * bins->side + column;
}

float bins_solid_angle(const struct bins *bins, const float direction[3], float length) {
    float cosine = fabsf(direction[major_axis(direction)]) / length;
    float width = 2 / (float)bins->side;
    return width * width * cosine * cosine * cosine;
}

/* Of the quarter-plane's corner at (x, y) on a face at distance 1. */
static double corner_angle(double x, double y) {
    return atan2(x * y, sqrt(x * x + y * y + 1));
}

static vec3s direction_at(int face, float x, float y) {
    vec3s direction;
    int axis = face / 2;
    direction.raw[axis] = face % 2 ? -1 : 1;
    direction.raw[(axis + 1) % 3] = x;
    direction.raw[(axis + 2) % 3] = y;
    return direction;
}

static void fill_bin(const struct bins *bins, int b) {
    struct bin *bin = &bins->items[b];
    const int side = bins->side, face = b / (side * side);
    const float width = 2 / (float)side;
    float x = (float)(b % side) * width - 1, y = (float)(b / side % side) * width - 1;
    bins->directions[b] = vec3s_unit(direction_at(face, x + width / 2, y + width / 2));
    for (int p = 0; p < BIN_PARTS; p++) {
        double x0 = (double)(x + (float)(p % 2) * width / 2), x1 = x0 + (double)width / 2;
        double y0 = (double)(y + (float)(p / 2) * width / 2), y1 = y0 + (double)width / 2;
        double angle = corner_angle(x1, y1) - corner_angle(x0, y1) - corner_angle(x1, y0) +
                       corner_angle(x0, y0);
        vec3s middle = direction_at(face, (float)(x0 + x1) / 2, (float)(y0 + y1) / 2);
        bin->parts[p] = glms_vec3_scale(vec3s_unit(middle), (float)angle);
    }
    for (int k = 0, i = 0; k < 9; k++) {
        float dx = (float)(k % 3 - 1) * width, dy = (float)(k / 3 - 1) * width;
        vec3s near = direction_at(face, x + width / 2 + dx, y + width / 2 + dy);
        if (k != 4)
            bin->neighbours[i++] = (uint16_t)bins_find(bins, near.raw);
    }
}

void bins_init(struct bins *bins, int side) {
    *bins = (struct bins){.side = side, .count = 6 * side * side};
    bins->items = mem_alloc((size_t)bins->count, sizeof *bins->items);
    bins->directions = mem_alloc((size_t)bins->count, sizeof *bins->directions);
    for (int b = 0; b < bins->count; b++)
        fill_bin(bins, b);
}

void bins_free(struct bins *bins) {
    mem_free(bins->items, bins->directions);
    *bins = (struct bins){0};
}

/* Seen from the middle of the cube. */
bool bins_window_of(const struct bins *bins, int face, const float center[3],
                    const float extents[3], struct bins_window *window) {
    int axis = face / 2;
    float depth = face % 2 ? -center[axis] : center[axis], radius = extents[axis];
    if (depth + radius <= 0)
        return false;
    window->inside = depth > radius;
    for (int c = 0; c < 2; c++) {
        float middle = center[(axis + 1 + c) % 3], extent = extents[(axis + 1 + c) % 3];
        float low = middle - extent, high = middle + extent;
        window->first[c] = 0;
        window->end[c] = bins->side;
        if (depth <= radius)
            continue;
        low /= low < 0 ? depth - radius : depth + radius;
        high /= high > 0 ? depth - radius : depth + radius;
        if (low > 1 || high < -1)
            return false;
        window->inside &= low > -1 && high < 1;
        window->first[c] = cell_of(bins, low);
        window->end[c] = cell_of(bins, high) + 1;
    }
    return true;
}

float bin_cosine(const struct bin *bin, vec3s normal) {
    float sum = 0, part;
    for (int p = 0; p < BIN_PARTS; p++) {
        part = glms_vec3_dot(bin->parts[p], normal);
        sum += part > 0 ? part : 0;
    }
    return sum;
}
