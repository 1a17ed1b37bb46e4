/* Metaballs: balls that drift through a box and melt into each other [Dong 2009, Table 1].
 *
 * Each ball adds (1 - (d/R)^2)^3 within its reach R, after the soft objects of [Wyvill et al.
 * 1986]; the surface lies where the sum is a quarter. A ball alone has a radius of 0.61 R.
 * Everything is a function of time and comes back after one period.
 */
#ifndef SCENE_SHAPES_METABALLS_H
#define SCENE_SHAPES_METABALLS_H

#include <stdbool.h>

struct marching_cubes;
struct surface;

enum { METABALLS_MAX = 64, METABALLS_MAX_CELLS = 1 << 22 };

struct metaballs {
    int count;             /* of balls, at most METABALLS_MAX */
    float low[3], high[3]; /* the box in which the surface stays; at least 2.6 reach wide */
    float reach;           /* of a ball of middle size; they are 0.7 to 1.3 of it */
    float cell;            /* side of the polygoniser's cubes */
    float period;          /* seconds */
};

/* Whether the numbers can be polygonised: finite, within their bounds, and no more than
 * METABALLS_MAX_CELLS cubes. */
bool metaballs_are_sound(const struct metaballs *balls);

/* Adds the surface at a time to one that the caller may have cleared. */
void metaballs_polygonise(const struct metaballs *balls, double time, struct marching_cubes *cubes,
                          struct surface *surface);

#endif
