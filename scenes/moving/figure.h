/* Figures with a skeleton: a soft body around bones, a skin that follows them, and a gait.
 *
 * At rest the bones lie as the table says, unturned. Each swings about an axis through its start as
 * a sine of time; those that hang on it go along. */
#ifndef SCENES_FIGURE_H
#define SCENES_FIGURE_H

#include "glb.h"

enum { FIGURE_BONES_MAX = 24 };

struct figure_bone {
    const char *name;
    int parent; /* an earlier bone; -1 for the first */
    float from[3], from_radius, to[3], to_radius;
    float blend; /* width of the seam */
    char axis;   /* 'x', 'y' or 'z': about which it swings */
    float rest;  /* degrees it is turned by in the middle */
    float swing; /* degrees to either side */
    float phase; /* of the cycle, when it passes the middle */
};

/* Looks along +x, stands on y = 0. */
struct figure {
    const char *name;
    const struct figure_bone *bones;
    int bone_count;
    float cell;  /* side of the polygoniser's cubes, metres */
    int faces;   /* after decimation */
    float cycle; /* seconds */
};

/* Where a figure goes: keys in seconds, the place of its first bone's foot point, and the heading
 * about y in degrees (0 = along +x). */
struct figure_path {
    int keys;
    const float *times;
    const float (*places)[3];
    const float *headings;
};

/* Adds the figure's nodes, its mesh, and its motion for so many seconds. scale makes it larger and
 * its steps slower by the root. */
void add_figure(struct glb *glb, const struct figure *figure, int material, float scale,
                const struct figure_path *path, float seconds);

#endif
