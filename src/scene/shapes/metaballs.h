/* Metaballs: balls that drift in a box and merge [Dong 2009, Table 1].
 *
 * Each ball adds (1 - (d/R)^2)^3 within its reach R [Wyvill et al. 1986, soft objects]. The surface
 * is at the value 1/4; a single ball has a radius of 0.61 R. Motion is a function of time with one
 * period. */
#ifndef SCENE_SHAPES_METABALLS_H
#define SCENE_SHAPES_METABALLS_H

#include <stdbool.h>

struct marching_cubes;
struct surface;

enum { METABALLS_MAX = 64, METABALLS_MAX_CELLS = 1 << 22 };

struct metaballs {
    int count;             /* number of balls, at most METABALLS_MAX */
    float low[3], high[3]; /* box of the surface; at least 2.6 reach wide */
    float reach;           /* of a medium ball; balls have .7 to 1.3 times this */
    float cell;            /* side of the cubes, metres */
    float period;          /* seconds */
};

/* True if the numbers are finite, within their bounds, and give at most METABALLS_MAX_CELLS
 * cubes. */
bool metaballs_are_sound(const struct metaballs *balls);

/* Appends the surface at a time, seconds. */
void metaballs_polygonise(const struct metaballs *balls, double time, struct marching_cubes *cubes,
                          struct surface *surface);

#endif
