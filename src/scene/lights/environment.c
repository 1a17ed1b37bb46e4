#include "scene/lights/environment.h"

#include "base/error.h"
#include "base/file/piped_file.h"
#include "base/log.h"
#include "base/memory.h"
#include "scene/lights/sky_formula.h"
#include "scene/read_rules.h"

#include <cglm/cglm.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* --- files ------------------------------------------------------------------------------------ */

/* Panoramas of an odd size are a texel off; other shapes are another projection. */
static bool check_picture(const struct image *image, const char *path) {
    int width = image->width, height = image->height;
    if (image->encoded)
        return error_set("its format is for displays: radiance comes in .hdr and .exr");
    if (2 * width < 3 * height || 2 * width > 5 * height)
        return error_set("%d x %d pixels are no panorama, which is twice as wide as high", width,
                         height);
    if (width == 2 * height)
        return true;
    if (read_rules_are_strict())
        return error_set("%d x %d pixels are not twice as wide as high", width, height);
    log_note("%s: %d x %d pixels, not twice as wide as high, are spread over the whole sphere",
             path, width, height);
    return true;
}

/* Texels with numbers that are no radiance, which other programs write now and then. */
struct odd_texels {
    int negative, infinite, not_numbers;
    int x, y; /* of the first */
};

/* The radiance that a number stands for; what is odd about it is counted. */
static float take_number(float number, struct odd_texels *odd) {
    static const float most_of_half = 65504; /* most panoramas are of halves */
    if (isnan(number))
        odd->not_numbers++;
    else if (number < 0)
        odd->negative++;
    else if (isinf(number))
        odd->infinite++;
    else
        return number;
    return number > 0 ? most_of_half : 0;
}

static int count_odd(const struct odd_texels *odd) {
    return odd->negative + odd->infinite + odd->not_numbers;
}

/* A texel counts once for each kind of odd numbers that it has. */
static void take_texel(float to[3], const struct image *image, const int channels[3], int x, int y,
                       struct odd_texels *odd) {
    const float *from = image_at(image, x, y);
    struct odd_texels own = {0};
    for (int c = 0; c < 3; c++)
        to[c] = take_number(from[channels[c]], &own);
    if (count_odd(odd) == 0) {
        odd->x = x;
        odd->y = y;
    }
    odd->negative += own.negative > 0;
    odd->infinite += own.infinite > 0;
    odd->not_numbers += own.not_numbers > 0;
}

static bool tell_odd(const struct odd_texels *odd, const char *path) {
    char list[256] = "";
    const struct {
        int count;
        const char *taken;
    } rows[] = {{odd->negative, "negative (0 instead)"},
                {odd->infinite, "infinite (65504 instead)"},
                {odd->not_numbers, "no numbers (0 instead)"}};
    if (count_odd(odd) == 0)
        return true;
    for (int i = 0; i < 3; i++)
        if (rows[i].count)
            snprintf(list + strlen(list), sizeof list - strlen(list), "%s%d %s", *list ? ", " : "",
                     rows[i].count, rows[i].taken);
    if (read_rules_are_strict())
        return error_set("texels that are no radiance: %s; first in column %d, row %d", list,
                         odd->x, odd->y);
    log_note("%s: texels that are no radiance: %s; first in column %d, row %d", path, list, odd->x,
             odd->y);
    return true;
}

/* The mean, by solid angle, of the picture's texels that one of the environment's stands for. */
static void take_block(struct environment *environment, const struct image *image,
                       const int channels[3], int column, int row, struct odd_texels *odd) {
    int width = environment->width, height = environment->height;
    int left = (int)((int64_t)column * image->width / width);
    int right = (int)((int64_t)(column + 1) * image->width / width);
    int top = (int)((int64_t)row * image->height / height);
    int bottom = (int)((int64_t)(row + 1) * image->height / height);
    double sum[3] = {0}, weights = 0;
    for (int y = top; y < bottom; y++)
        for (int x = left; x < right; x++) {
            float texel[3];
            double weight = sin((y + .5) / image->height * GLM_PI);
            take_texel(texel, image, channels, x, y, odd);
            for (int c = 0; c < 3; c++)
                sum[c] += weight * (double)texel[c];
            weights += weight;
        }
    float *to = environment->texels[(size_t)row * (size_t)width + (size_t)column];
    for (int c = 0; c < 3; c++)
        to[c] = (float)(sum[c] / weights);
}

/* Wider ones cost much and show no more. */
enum { WIDEST = 8192 };

/* --- cubes [OpenEXR, ImfEnvmap.h] ------------------------------------------------------------- */

/* Where a direction meets the squares of a cube: +X -X +Y -Y +Z -Z, one below the other. Centres of
 * texels along an edge lie on the edge. */
static void cube_place(const float d[3], int side, double place[2], int *top) {
    int axis = fabsf(d[0]) >= fabsf(d[1]) && fabsf(d[0]) >= fabsf(d[2]) ? 0
               : fabsf(d[1]) >= fabsf(d[2])                             ? 1
                                                                        : 2;
    bool below = d[axis] < 0;
    double scale = 1 / fabs((double)d[axis]), x = (double)d[0] * scale, y = (double)d[1] * scale,
           z = (double)d[2] * scale;
    place[0] = axis == 0 ? (below ? -z : z) : axis == 1 ? x : below ? x : -x;
    place[1] = axis == 1 ? (below ? z : -z) : -y;
    for (int i = 0; i < 2; i++)
        place[i] = (place[i] + 1) / 2 * (side - 1);
    *top = (2 * axis + below) * side;
}

/* Adds what lies between four texels. */
static void add_cube(const float (*texels)[3], int side, const float direction[3], double sum[3]) {
    double place[2];
    int top;
    cube_place(direction, side, place, &top);
    int x = (int)fmin(place[0], side - 2), y = (int)fmin(place[1], side - 2);
    for (int i = 0; i < 4; i++) {
        int column = x + i % 2, row = y + i / 2;
        double weight = (1 - fabs(place[0] - column)) * (1 - fabs(place[1] - row));
        for (int c = 0; c < 3; c++)
            sum[c] += weight * (double)texels[(top + row) * side + column][c];
    }
}

/* A panorama of the cube's, which looks along +Z in the middle as OpenEXR's have it: +X of the
 * scene. */
static void take_cube(struct environment *environment, const float (*texels)[3], int side) {
    enum { SAMPLES = 3 }; /* a side of a texel */
    for (int i = 0; i < environment->width * environment->height; i++) {
        double sum[3] = {0};
        for (int s = 0; s < SAMPLES * SAMPLES; s++) {
            float d[3];
            environment_direction(environment,
                                  i % environment->width + (s % SAMPLES + .5) / SAMPLES,
                                  i / environment->width + (s / SAMPLES + .5) / SAMPLES, d);
            add_cube(texels, side, (float[]){-d[2], d[1], d[0]}, sum);
        }
        for (int c = 0; c < 3; c++)
            environment->texels[i][c] = (float)(sum[c] / (SAMPLES * SAMPLES));
    }
}

static bool load_cube(struct environment *environment, const struct image *image,
                      const int channels[3], const char *path) {
    struct odd_texels odd = {0};
    int side = image->width;
    if (image->encoded || image->height != 6 * side || side < 2)
        return error_set("%d x %d pixels are no cube of light: six squares, one below the other",
                         side, image->height);
    environment->width = 4 * side < WIDEST ? 4 * side : WIDEST;
    environment->height = environment->width / 2;
    size_t count = (size_t)environment->width * (size_t)environment->height;
    float(*texels)[3] = mem_alloc((size_t)side * (size_t)image->height, sizeof *texels);
    for (int y = 0; y < image->height; y++)
        for (int x = 0; x < side; x++)
            take_texel(texels[(size_t)y * (size_t)side + (size_t)x], image, channels, x, y, &odd);
    environment->texels = mem_alloc(count, sizeof *environment->texels);
    take_cube(environment, (const float(*)[3])texels, side);
    free(texels);
    return tell_odd(&odd, path);
}

/* --- panoramas -------------------------------------------------------------------------------- */

static bool take_texels(struct environment *environment, const struct image *image,
                        const int channels[3], const char *path) {
    struct odd_texels odd = {0};
    if (!check_picture(image, path))
        return false;
    int less = (image->width + WIDEST - 1) / WIDEST;
    environment->width = image->width / less;
    environment->height = image->height / less;
    environment->texels = mem_alloc((size_t)environment->width * (size_t)environment->height,
                                    sizeof *environment->texels);
    for (int y = 0; y < environment->height; y++)
        for (int x = 0; x < environment->width; x++)
            take_block(environment, image, channels, x, y, &odd);
    if (less > 1)
        log_note("%s: scaled from %d x %d to %d x %d", path, image->width, image->height,
                 environment->width, environment->height);
    return tell_odd(&odd, path);
}

static bool load_file(struct environment *environment, const char *path) {
    struct image image;
    int channels[3];
    *environment = (struct environment){.strength = 1};
    if (!piped_image_read_layer(&image, path, "", channels))
        return false;
    bool ok = (image.cube ? load_cube : take_texels)(environment, &image, channels, path) ||
              error_prefix("%s", path);
    image_free(&image);
    return ok;
}

bool environment_load(struct environment *environment, const char *path) {
    if ((sky_formula_is(path) ? sky_formula_make : load_file)(environment, path)) {
        environment->path = mem_strdup(path);
        return true;
    }
    free(environment->texels);
    return false;
}

void environment_free(struct environment *environment) {
    if (!environment)
        return;
    mem_free(environment->texels, environment->path, environment);
}

bool environment_follow(struct environment **environment, const struct environment_desc *desc) {
    if (desc->path) {
        struct environment *loaded = mem_alloc(1, sizeof *loaded);
        if (!environment_load(loaded, desc->path)) {
            free(loaded);
            return false;
        }
        environment_free(*environment);
        *environment = loaded;
    }
    bool changes = desc->turn != 0 || (desc->strength != 0 && desc->strength != 1);
    if (!*environment)
        return !changes || error_set("there is no environment to be turned or made stronger");
    (*environment)->turn += desc->turn;
    if (desc->strength != 0)
        (*environment)->strength *= desc->strength;
    return true;
}

/* --- directions ------------------------------------------------------------------------------- */

static double turn_of(const struct environment *environment) {
    return (double)environment->turn * GLM_PI / 180;
}

void environment_texel(const struct environment *environment, const float direction[3], int *x,
                       int *y) {
    double across = hypot((double)direction[0], (double)direction[2]);
    double azimuth = atan2((double)direction[2], (double)direction[0]) + turn_of(environment);
    double u = azimuth / (2 * GLM_PI) + .5, v = atan2(across, (double)direction[1]) / GLM_PI;
    int column = (int)floor((u - floor(u)) * environment->width);
    int row = (int)floor(v * environment->height);
    /* What is next to 1 may be rounded to it; and straight down is the last row's. */
    *x = column < environment->width ? column : 0;
    *y = row < environment->height ? row : environment->height - 1;
}

void environment_radiance(const struct environment *environment, const float direction[3],
                          float radiance[3]) {
    int x, y;
    environment_texel(environment, direction, &x, &y);
    const float *texel = environment->texels[(size_t)y * (size_t)environment->width + (size_t)x];
    for (int c = 0; c < 3; c++)
        radiance[c] = environment->strength * texel[c];
}

void environment_direction(const struct environment *environment, double x, double y,
                           float direction[3]) {
    double azimuth = (x / environment->width - .5) * 2 * GLM_PI - turn_of(environment);
    double polar = y / environment->height * GLM_PI;
    direction[0] = (float)(sin(polar) * cos(azimuth));
    direction[1] = (float)cos(polar);
    direction[2] = (float)(sin(polar) * sin(azimuth));
}

/* The difference of the cosines of its edges, as a product: next to the poles they are almost the
 * same. */
double environment_solid_angle(const struct environment *environment, int y) {
    double half = GLM_PI / (2 * environment->height), middle = (2 * y + 1) * half;
    return 2 * GLM_PI / environment->width * 2 * sin(middle) * sin(half);
}
