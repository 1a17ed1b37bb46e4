/* Environments at infinite distance: a sky as a panorama in latitude and longitude.
 *
 * Texels have constant radiance without interpolation, so that camera and lighting agree. The top
 * of the picture is +Y. From left to right the azimuth atan2(z, x) goes from -pi to pi. The left
 * edge is -X, then follow -Z, the centre +X, and +Z. A turn moves +Z towards +X, right-handed about
 * +Y. */
#ifndef SCENE_LIGHTS_ENVIRONMENT_H
#define SCENE_LIGHTS_ENVIRONMENT_H

#include <stdbool.h>

struct environment {
    char *path;
    int width, height; /* width about 2 height */
    /* Linear RGB from the top row, W/(sr m2) at strength 1; finite, not negative. */
    float (*texels)[3];
    float turn;     /* degrees */
    float strength; /* factor */
};

/* Loads a file, or makes a sky of a text (scene/lights/sky_formula.h), with turn 0 and strength 1.
 * Negative numbers and NaN become 0, infinite ones 65504; a note counts their texels. Error: names
 * the file and the reason. It is unreadable, not linear, or neither twice as wide as high nor an
 * EXR cube map. With --strict replaced numbers are errors. */
bool environment_load(struct environment *environment, const char *path);

/* Accepts NULL. */
void environment_free(struct environment *environment);

/* Writes column and row of the texel in `direction`, which need not be unit. */
void environment_texel(const struct environment *environment, const float direction[3], int *x,
                       int *y);

/* Writes the radiance from `direction`, W/(sr m2). */
void environment_radiance(const struct environment *environment, const float direction[3],
                          float radiance[3]);

/* Writes the unit direction of a point of the picture, in texels from its top left corner. */
void environment_direction(const struct environment *environment, double x, double y,
                           float direction[3]);

/* Returns the solid angle of each texel of row y, sr. */
double environment_solid_angle(const struct environment *environment, int y);

/* Replacement of a scene's environment, or changes to it. */
struct environment_desc {
    const char *path; /* NULL: the scene's own */
    float turn;       /* added degrees */
    float strength;   /* factor; 0: 1 */
};

/* Changes *environment as described and frees what it replaces; NULL: none. Error: that of the
 * file, or no environment to change. */
bool environment_follow(struct environment **environment, const struct environment_desc *desc);

#endif
