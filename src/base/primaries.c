#include "base/primaries.h"

#include <math.h>
#include <string.h>

const float primaries_bt709[PRIMARIES_NUMBERS] = {.64f, .33f, .3f, .6f, .15f, .06f, .3127f, .329f};

/* XYZ to the responses of cones, by which Bradford adapts. */
static const double bradford[3][3] = {
    {.8951, .2664, -.1614}, {-.7502, 1.7135, .0367}, {.0389, -.0685, 1.0296}};

static void multiply(const double a[3][3], const double b[3][3], double product[3][3]) {
    double sum[3][3] = {{0}};
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            for (int j = 0; j < 3; j++)
                sum[i][j] += a[i][k] * b[k][j];
    memcpy(product, sum, sizeof sum);
}

static void transform(const double matrix[3][3], const double from[3], double to[3]) {
    for (int i = 0; i < 3; i++)
        to[i] = matrix[i][0] * from[0] + matrix[i][1] * from[1] + matrix[i][2] * from[2];
}

/* By cofactors. False: there is no inverse. */
static bool invert(const double m[3][3], double inverse[3][3]) {
    double determinant = 0;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            int a = (j + 1) % 3, b = (j + 2) % 3, c = (i + 1) % 3, d = (i + 2) % 3;
            inverse[i][j] = m[a][c] * m[b][d] - m[a][d] * m[b][c];
        }
    for (int j = 0; j < 3; j++)
        determinant += m[0][j] * inverse[j][0];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            inverse[i][j] /= determinant;
    return fabs(determinant) > 1e-6; /* also of NaN */
}

/* XYZ of white, of luminance 1, and of RGB: columns are the primaries, as bright as white needs them. */
static bool matrix_to_xyz(const float primaries[PRIMARIES_NUMBERS], double white[3],
                          double matrix[3][3]) {
    double inverse[3][3], shares[3], w[3];
    for (int c = 0; c < 4; c++) {
        double x = (double)primaries[2 * c], y = (double)primaries[2 * c + 1];
        const double xyz[3] = {x, y, 1 - x - y};
        for (int i = 0; i < 3; i++)
            *(c < 3 ? &matrix[i][c] : &w[i]) = xyz[i];
    }
    for (int i = 0; i < 3; i++)
        white[i] = w[i] / w[1];
    if (!(w[1] > 0) || !invert(matrix, inverse))
        return false;
    transform(inverse, white, shares);
    for (int i = 0; i < 3; i++)
        for (int c = 0; c < 3; c++)
            matrix[i][c] *= shares[c];
    return true;
}

void primaries_matrix_of_xyz(double matrix[3][3]) {
    double white[3], to_xyz[3][3];
    matrix_to_xyz(primaries_bt709, white, to_xyz);
    invert(to_xyz, matrix);
}

bool primaries_matrix(const float primaries[PRIMARIES_NUMBERS], double matrix[3][3]) {
    double white[3], own_white[3], cones[3], own_cones[3], own[3][3], adapt[3][3] = {{0}};
    if (!matrix_to_xyz(primaries, white, matrix))
        return false;
    matrix_to_xyz(primaries_bt709, own_white, own);
    transform(bradford, white, cones);
    transform(bradford, own_white, own_cones);
    for (int i = 0; i < 3; i++)
        adapt[i][i] = own_cones[i] / cones[i];
    multiply(bradford, matrix, matrix);
    multiply(adapt, matrix, matrix);
    invert(bradford, adapt);
    multiply(adapt, matrix, matrix);
    primaries_matrix_of_xyz(own);
    multiply(own, matrix, matrix);
    return isfinite(matrix[0][0] + matrix[1][1] + matrix[2][2]);
}

bool primaries_are_bt709(const float primaries[PRIMARIES_NUMBERS]) {
    for (int i = 0; i < PRIMARIES_NUMBERS; i++)
        if (!(fabsf(primaries[i] - primaries_bt709[i]) < 1e-3f))
            return false;
    return true;
}
