/* What lies around a scene, infinitely far away: a sky, as a panorama in latitude and longitude.
 *
 * Texels are patches of even radiance, within which nothing is interpolated, so that what is seen and
 * what lights a scene are the same. The picture's top is +Y. From its left to its right the azimuth
 * atan2(z, x) goes from -pi to pi: the left edge, u = 0, lies at -X, a quarter on is -Z, the middle is
 * +X, three quarters +Z. A turn moves what lies at +Z towards +X, right-handed about +Y.
 */
#ifndef SCENE_LIGHTS_ENVIRONMENT_H
#define SCENE_LIGHTS_ENVIRONMENT_H

#include <stdbool.h>

struct environment {
    char *path;
    int width, height; /* width = 2 height, or about */
    float (
        *texels)[3]; /* linear RGB from the top row on, W/(sr m2) where strength is 1; finite, none
                           negative */
    float turn;      /* degrees */
    float strength;  /* a factor */
};

/* Without a turn, of strength 1. Numbers that are negative or none become 0, infinite ones 65504, and a
 * note counts their texels. Error: names the file and what is wrong with it: it cannot be read, or is no
 * linear picture twice as wide as high, nor an EXR of six squares whose envmap attribute says cube; under
 * --strict also where a number would be replaced. */
bool environment_load(struct environment *environment, const char *path);

/* Accepts NULL. */
void environment_free(struct environment *environment);

/* The column and row of the texel where the direction, which need not be unit, leads. */
void environment_texel(const struct environment *environment, const float direction[3], int *x,
                       int *y);

/* The radiance that comes from there. */
void environment_radiance(const struct environment *environment, const float direction[3],
                          float radiance[3]);

/* The other way round: the unit direction of a point of the picture, in texels from its top left corner. */
void environment_direction(const struct environment *environment, double x, double y,
                           float direction[3]);

/* Of each texel of a row, sr. */
double environment_solid_angle(const struct environment *environment, int y);

/* What a scene's environment is to be instead, or how to change it. */
struct environment_desc {
    const char *path; /* NULL = its own */
    float turn;       /* degrees more */
    float strength;   /* times as strong; 0 = 1 */
};

/* Frees what *environment points to and makes it what is wanted; NULL is none. Error: the file's, and
 * where there is none to be changed. */
bool environment_follow(struct environment **environment, const struct environment_desc *desc);

#endif
