/* LDR-FLIP straight from its definition, slowly: two-dimensional kernels, doubles, one pixel at a
 * time. A second implementation to hold metrics/flip/flip.h against. */
#ifndef TEST_FLIP_DIRECT_H
#define TEST_FLIP_DIRECT_H

#include "base/image.h"

#include <math.h>

static const double pi = 3.14159265358979323846;

static const double matrix[3][3] = {
    {10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794},
    {2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897},
    {1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382}};

/* XYZ over the white's. */
static void xyz_of(const double rgb[3], double xyz[3]) {
    for (int i = 0; i < 3; i++) {
        double white = matrix[i][0] + matrix[i][1] + matrix[i][2];
        xyz[i] = (matrix[i][0] * rgb[0] + matrix[i][1] * rgb[1] + matrix[i][2] * rgb[2]) / white;
    }
}

/* Cramer's rule on the matrix. */
static void rgb_of(const double xyz[3], double rgb[3]) {
    double m[3][3], in[3];
    for (int i = 0; i < 3; i++) {
        in[i] = xyz[i] * (matrix[i][0] + matrix[i][1] + matrix[i][2]);
        for (int j = 0; j < 3; j++)
            m[i][j] = matrix[i][j];
    }
    double minor[3][3], determinant = 0;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            minor[i][j] = m[(i + 1) % 3][(j + 1) % 3] * m[(i + 2) % 3][(j + 2) % 3] -
                          m[(i + 1) % 3][(j + 2) % 3] * m[(i + 2) % 3][(j + 1) % 3];
    for (int j = 0; j < 3; j++)
        determinant += m[0][j] * minor[0][j];
    for (int j = 0; j < 3; j++)
        rgb[j] = (minor[0][j] * in[0] + minor[1][j] * in[1] + minor[2][j] * in[2]) / determinant;
}

static void pixel_xyz(const struct image *image, int x, int y, double xyz[3]) {
    x = x < 0 ? 0 : x < image->width ? x : image->width - 1;
    y = y < 0 ? 0 : y < image->height ? y : image->height - 1;
    const float *pixel = image_at(image, x, y);
    xyz_of((const double[]){(double)pixel[0], (double)pixel[1], (double)pixel[2]}, xyz);
}

/* Contrast sensitivity of channel c at squared distance d2, in degrees. */
static double sensitivity(int c, double d2) {
    static const double a1[] = {1, 1, 34.1}, b1[] = {.0047, .0053, .04};
    static const double a2[] = {0, 0, 13.5}, b2[] = {1e-5, 1e-5, .025};
    return a1[c] * sqrt(pi / b1[c]) * exp(-pi * pi * d2 / b1[c]) +
           a2[c] * sqrt(pi / b2[c]) * exp(-pi * pi * d2 / b2[c]);
}

static double lab_root(double t) {
    return t > 216.0 / 24389 ? cbrt(t) : t * 841 / 108 + 4.0 / 29;
}

static void hunt_lab(const double rgb[3], double lab[3]) {
    double xyz[3];
    xyz_of(rgb, xyz);
    lab[0] = 116 * lab_root(xyz[1]) - 16;
    lab[1] = 500 * (lab_root(xyz[0]) - lab_root(xyz[1])) * .01 * lab[0];
    lab[2] = 200 * (lab_root(xyz[1]) - lab_root(xyz[2])) * .01 * lab[0];
}

static void seen_lab(const struct image *image, double ppd, int x, int y, double lab[3]) {
    int radius = (int)ceil(3 * sqrt(.04 / (2 * pi * pi)) * ppd);
    double sum[3] = {0}, weight[3] = {0};
    for (int dy = -radius; dy <= radius; dy++)
        for (int dx = -radius; dx <= radius; dx++) {
            double xyz[3];
            pixel_xyz(image, x + dx, y + dy, xyz);
            double opponent[] = {116 * xyz[1] - 16, 500 * (xyz[0] - xyz[1]),
                                 200 * (xyz[1] - xyz[2])};
            for (int c = 0; c < 3; c++) {
                double w = sensitivity(c, (dx * dx + dy * dy) / (ppd * ppd));
                sum[c] += w * opponent[c];
                weight[c] += w;
            }
        }
    double luminance = (sum[0] / weight[0] + 16) / 116, rgb[3];
    rgb_of((const double[]){luminance + sum[1] / weight[1] / 500, luminance,
                            luminance - sum[2] / weight[2] / 200},
           rgb);
    for (int c = 0; c < 3; c++)
        rgb[c] = fmin(fmax(rgb[c], 0), 1);
    hunt_lab(rgb, lab);
}

static double distance(const double a[3], const double b[3]) {
    return pow(fabs(a[0] - b[0]) + hypot(a[1] - b[1], a[2] - b[2]), .7);
}

/* The strength of an edge (or a point) along x and y: positive weights sum 1, negative -1. */
static double feature(const struct image *image, double ppd, int x, int y, int is_point) {
    double sigma = .5 * .082 * ppd, sums[2][2] = {{0}}, weights[2][2] = {{0}};
    int radius = (int)ceil(3 * sigma);
    for (int dy = -radius; dy <= radius; dy++)
        for (int dx = -radius; dx <= radius; dx++) {
            double xyz[3], along[] = {dx, dy};
            pixel_xyz(image, x + dx, y + dy, xyz);
            for (int axis = 0; axis < 2; axis++) {
                double t = along[axis], g = exp(-(dx * dx + dy * dy) / (2 * sigma * sigma));
                double w = (is_point ? t * t / (sigma * sigma) - 1 : -t) * g;
                sums[axis][w < 0] += fabs(w) * xyz[1];
                weights[axis][w < 0] += fabs(w);
            }
        }
    double strength[2];
    for (int axis = 0; axis < 2; axis++)
        strength[axis] = sums[axis][0] / weights[axis][0] - sums[axis][1] / weights[axis][1];
    return hypot(strength[0], strength[1]);
}

/* The error at pixel x, y of two pictures of linear R G B in [0, 1]. */
static double flip_direct(const struct image *test, const struct image *reference, double ppd,
                          int x, int y) {
    double a[3], b[3], green[3], blue[3];
    seen_lab(test, ppd, x, y, a);
    seen_lab(reference, ppd, x, y, b);
    hunt_lab((const double[]){0, 1, 0}, green);
    hunt_lab((const double[]){0, 0, 1}, blue);
    double colour = distance(a, b), largest = distance(green, blue), knee = .4 * largest;
    colour = colour < knee ? colour / knee * .95 : .95 + (colour - knee) / (largest - knee) * .05;
    double difference[2];
    for (int is_point = 0; is_point < 2; is_point++)
        difference[is_point] =
            fabs(feature(test, ppd, x, y, is_point) - feature(reference, ppd, x, y, is_point));
    return pow(colour, 1 - sqrt(fmax(difference[0], difference[1]) / sqrt(2)));
}

#endif
