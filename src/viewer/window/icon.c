#include "viewer/window/icon.h"

#include <math.h>

/* Of a square of side 1, y down. */
static const struct disc {
    float x, y, radius;
    unsigned char color[3];
} discs[] = {
    {.50F, .27F, .13F, {255, 236, 190}}, /* the lamp */
    {.19F, .46F, .06F, {232, 92, 70}},   {.18F, .69F, .05F, {190, 70, 56}},
    {.81F, .46F, .06F, {108, 196, 96}},  {.82F, .69F, .05F, {84, 156, 78}},
    {.35F, .79F, .07F, {240, 168, 72}},  {.52F, .73F, .06F, {244, 190, 112}},
    {.67F, .81F, .06F, {226, 150, 60}},  {.50F, .53F, .04F, {214, 190, 150}},
};

enum { DISCS = sizeof discs / sizeof *discs };

/* How much of a pixel lies in what ends that far from its middle, pixels. */
static float coverage(float inside) {
    return fminf(fmaxf(inside + .5F, 0), 1);
}

/* How far a place lies within the square with round corners. */
static float inside_ground(float x, float y) {
    const float round = .18F;
    float dx = fmaxf(fabsf(x - .5F) - (.5F - round), 0);
    float dy = fmaxf(fabsf(y - .5F) - (.5F - round), 0);
    return round - hypotf(dx, dy);
}

static void draw_pixel(unsigned char *rgba, float x, float y, float size) {
    float color[3] = {34, 37, 46};
    for (int i = 0; i < DISCS; i++) {
        float inside = discs[i].radius - hypotf(x - discs[i].x, y - discs[i].y);
        float share = coverage(inside * size);
        for (int c = 0; c < 3; c++)
            color[c] += share * ((float)discs[i].color[c] - color[c]);
    }
    for (int c = 0; c < 3; c++)
        rgba[c] = (unsigned char)lrintf(color[c]);
    rgba[3] = (unsigned char)lrintf(255 * coverage(inside_ground(x, y) * size));
}

void icon_draw(unsigned char *rgba, int size) {
    for (int y = 0; y < size; y++)
        for (int x = 0; x < size; x++)
            draw_pixel(rgba + 4 * (y * size + x), ((float)x + .5F) / (float)size,
                       ((float)y + .5F) / (float)size, (float)size);
}
