#include "scene/environment.h"

#include "base/error.h"
#include "base/file/image_file.h"
#include "base/memory.h"

#include <cglm/cglm.h>
#include <math.h>
#include <stdlib.h>

/* --- files ------------------------------------------------------------------------------------ */

static bool check_picture(const struct image *image) {
    if (image->encoded)
        return error_set("its format is for displays: radiance comes in .hdr and .exr");
    return image->width == 2 * image->height ||
           error_set("%d x %d pixels are no panorama, which is twice as wide as high", image->width,
                     image->height);
}

static bool take_texel(struct environment *environment, const struct image *image,
                       const int channels[3], int x, int y) {
    const float *from = image_at(image, x, y);
    float *to = environment->texels[(size_t)y * (size_t)image->width + (size_t)x];
    for (int c = 0; c < 3; c++) {
        to[c] = from[channels[c]];
        if (!(to[c] >= 0) || !isfinite(to[c]))
            return error_set("the texel in column %d, row %d is (%g, %g, %g)", x, y,
                             (double)from[channels[0]], (double)from[channels[1]],
                             (double)from[channels[2]]);
    }
    return true;
}

static bool take_texels(struct environment *environment, const struct image *image,
                        const int channels[3]) {
    bool ok = check_picture(image);
    if (!ok)
        return false;
    environment->width = image->width;
    environment->height = image->height;
    environment->texels =
        mem_alloc((size_t)image->width * (size_t)image->height, sizeof *environment->texels);
    for (int y = 0; ok && y < image->height; y++)
        for (int x = 0; ok && x < image->width; x++)
            ok = take_texel(environment, image, channels, x, y);
    return ok;
}

bool environment_load(struct environment *environment, const char *path) {
    struct image image;
    int channels[3];
    *environment = (struct environment){.strength = 1};
    if (!image_read_layer(&image, path, "", channels))
        return false;
    bool ok = take_texels(environment, &image, channels) || error_prefix("%s", path);
    image_free(&image);
    if (ok)
        environment->path = mem_strdup(path);
    else
        free(environment->texels);
    return ok;
}

void environment_free(struct environment *environment) {
    if (!environment)
        return;
    free(environment->texels);
    free(environment->path);
    free(environment);
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

/* The difference of the cosines of its edges, as a product: next to the poles they are almost the same. */
double environment_solid_angle(const struct environment *environment, int y) {
    double half = GLM_PI / (2 * environment->height), middle = (2 * y + 1) * half;
    return 2 * GLM_PI / environment->width * 2 * sin(middle) * sin(half);
}
