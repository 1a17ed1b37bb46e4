/* Reads the points that a light meter measures: a table of text, or a grid on a plane. */
#ifndef APPS_POINTS_H
#define APPS_POINTS_H

#include "scene/camera.h"

struct points {
    double (*rows)[6];      /* x y z nx ny nz as given, metres of the file */
    struct sensor *sensors; /* the same in the scene's coordinates, after points_place */
    int count;
    int columns; /* of a grid: points along u */
};

/* Reads lines of x,y,z,nx,ny,nz and columns after these, which are left alone. A first line of
 * names, empty lines and lines after # are skipped. Error: names file, line and reason. */
bool points_read(struct points *points, const char *path);

/* Makes the middles of NUxNV cells of a parallelogram: "x,y,z,ux,uy,uz,vx,vy,vz,NUxNV", its corner
 * and two sides, metres. Normals are u x v. Error: names the text and the reason. */
bool points_parse_grid(struct points *points, const char *text);

/* Writes the sensors. origin: as of a scene. */
void points_place(struct points *points, const double origin[3]);

/* Accepts zeroed points. */
void points_free(struct points *points);

#endif
