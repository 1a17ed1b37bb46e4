#include "base/primaries.h"

#include <cglm/cglm.h>
#include <math.h>

const float primaries_bt709[PRIMARIES_NUMBERS] = {.64f, .33f, .3f, .6f, .15f, .06f, .3127f, .329f};

/* XYZ to the responses of cones, by which Bradford adapts; in columns. */
static mat3 bradford = {
    {.8951f, -.7502f, .0389f}, {.2664f, 1.7135f, -.0685f}, {-.1614f, .0367f, 1.0296f}};

static void xyz_of(const float xy[2], vec3 xyz) {
    glm_vec3_copy((vec3){xy[0], xy[1], 1 - xy[0] - xy[1]}, xyz);
}

/* XYZ of white, of luminance 1, and of RGB: columns are the primaries, as bright as white needs
 * them. */
static bool matrix_to_xyz(const float primaries[PRIMARIES_NUMBERS], vec3 white, mat3 matrix) {
    mat3 inverse;
    vec3 shares;
    for (int c = 0; c < 3; c++)
        xyz_of(primaries + 2 * c, matrix[c]);
    xyz_of(primaries + 6, white);
    if (!(white[1] > 0) || !(fabsf(glm_mat3_det(matrix)) > 1e-6f))
        return false;
    glm_vec3_divs(white, white[1], white);
    glm_mat3_inv(matrix, inverse);
    glm_mat3_mulv(inverse, white, shares);
    for (int c = 0; c < 3; c++)
        glm_vec3_scale(matrix[c], shares[c], matrix[c]);
    return true;
}

void primaries_matrix_of_xyz(float matrix[3][3]) {
    mat3 to_xyz;
    vec3 white;
    matrix_to_xyz(primaries_bt709, white, to_xyz);
    glm_mat3_inv(to_xyz, matrix);
}

bool primaries_matrix(const float primaries[PRIMARIES_NUMBERS], float matrix[3][3]) {
    mat3 own, adapt = GLM_MAT3_ZERO_INIT;
    vec3 white, own_white;
    if (!matrix_to_xyz(primaries, white, matrix))
        return false;
    matrix_to_xyz(primaries_bt709, own_white, own);
    glm_mat3_mulv(bradford, white, white);
    glm_mat3_mulv(bradford, own_white, own_white);
    for (int i = 0; i < 3; i++)
        adapt[i][i] = own_white[i] / white[i];
    glm_mat3_mul(bradford, matrix, matrix);
    glm_mat3_mul(adapt, matrix, matrix);
    glm_mat3_inv(bradford, adapt);
    glm_mat3_mul(adapt, matrix, matrix);
    primaries_matrix_of_xyz(own);
    glm_mat3_mul(own, matrix, matrix);
    return isfinite(matrix[0][0] + matrix[1][1] + matrix[2][2]);
}

bool primaries_are_bt709(const float primaries[PRIMARIES_NUMBERS]) {
    for (int i = 0; i < PRIMARIES_NUMBERS; i++)
        if (!(fabsf(primaries[i] - primaries_bt709[i]) < 1e-3f))
            return false;
    return true;
}
