#include "scene/lens.h"

#include "base/error.h"
#include "base/unit.h"

#include <math.h>
#include <string.h>

const char *const camera_lens_names[] = {"pinhole",     "equirectangular", "cube",
                                         "equidistant", "equisolid",       NULL};

bool camera_is_wide(const struct camera *camera) {
    return camera->lens != LENS_PINHOLE;
}

bool camera_is_distorted(const struct camera *camera) {
    bool any = camera->skew != 0;
    for (int i = 0; i < 8; i++)
        any |= camera->distortion[i] != 0;
    return any;
}

/* --- distortion ------------------------------------------------------------------------------- */

void lens_distort(const struct camera *camera, const double plane[2], double out[2]) {
    const float *k = camera->distortion;
    double x = plane[0], y = plane[1], r2 = x * x + y * y;
    double radial =
        (1 + r2 * (k[0] + r2 * (k[1] + r2 * k[4]))) / (1 + r2 * (k[5] + r2 * (k[6] + r2 * k[7])));
    out[1] = y * radial + k[2] * (r2 + 2 * y * y) + 2 * k[3] * x * y;
    out[0] = x * radial + 2 * k[2] * x * y + k[3] * (r2 + 2 * x * x) + camera->skew * out[1];
}

/* Newton's method. A fold of the model ends it. */
static bool refine(const struct camera *camera, double u, double v, double at[2]) {
    const double step = 1e-6;
    double here[2], right[2], down[2], off = 1;
    for (int i = 0; i < 50 && off > 1e-12; i++) {
        lens_distort(camera, at, here);
        lens_distort(camera, (double[]){at[0] + step, at[1]}, right);
        lens_distort(camera, (double[]){at[0], at[1] + step}, down);
        double a = (right[0] - here[0]) / step, b = (down[0] - here[0]) / step;
        double c = (right[1] - here[1]) / step, d = (down[1] - here[1]) / step;
        double det = a * d - b * c, x = u - here[0], y = v - here[1];
        if (!(det > 1e-6))
            return false;
        at[0] += (d * x - b * y) / det;
        at[1] += (a * y - c * x) / det;
        off = fabs(x) + fabs(y);
    }
    return off <= 1e-9;
}

/* From the middle outwards, so that the ray is the one before a fold. */
bool lens_undistort(const struct camera *camera, const double plane[2], double out[2]) {
    bool ok = true;
    out[0] = out[1] = 0;
    for (double part = .125; ok && part <= 1; part += .125)
        ok = refine(camera, part * plane[0], part * plane[1], out);
    return ok;
}

/* Tries points of the picture that the intrinsics are for. */
static bool check_distortion(const struct camera *camera) {
    double half = tan((double)camera->fov_y / 2), out[2];
    double across =
        half * camera->size[0] / camera->size[1] * (double)sqrtf(camera_axis_norm2(camera->right));
    for (int i = 0; i < 17 * 17; i++) {
        double x = i % 17 / 8. - 1, y = i / 17 / 8. - 1;
        if (!lens_undistort(camera,
                            (double[]){across * (x + (double)camera->shift[0]),
                                       half * (y - (double)camera->shift[1])},
                            out))
            return error_set("distortion: no ray is seen at the pixel %g, %g",
                             (x + 1) / 2 * camera->size[0], (y + 1) / 2 * camera->size[1]);
    }
    return true;
}

/* --- wide lenses ------------------------------------------------------------------------------ */

/* Axes of a cube's sides, right, up and forward: numbers + 1 of the camera's, or of their
 * opposites. */
static const int sides[6][3] = {{-3, 2, 1}, {3, 2, -1}, {1, -3, 2},
                                {1, 3, -2}, {1, 2, 3},  {-1, 2, -3}};

/* Takes numbers of the axes right, up and forward to those of a cube's side. */
static void to_side(const float axes[3], int side, float out[3]) {
    for (int i = 0; i < 3; i++) {
        int axis = sides[side][i];
        out[i] = axis > 0 ? axes[axis - 1] : -axes[-axis - 1];
    }
}

static void cube_ray(float x, float y, float axes[3]) {
    int side = (int)fminf(fmaxf(6 * x, 0), 5);
    const float of_side[3] = {2 * (6 * x - (float)side) - 1, 1 - 2 * y, 1};
    for (int i = 0; i < 3; i++) {
        int axis = sides[side][i];
        axes[axis > 0 ? axis - 1 : -axis - 1] = axis > 0 ? of_side[i] : -of_side[i];
    }
}

static void cube_place(const float axes[3], float place[2]) {
    float best[3] = {0, 0, 0}, of_side[3];
    int side = 0;
    for (int i = 0; i < 6; i++) {
        to_side(axes, i, of_side);
        if (of_side[2] > best[2]) {
            side = i;
            memcpy(best, of_side, sizeof best);
        }
    }
    place[0] = ((float)side + .5F + .5F * best[0] / best[2]) / 6;
    place[1] = .5F - .5F * best[1] / best[2];
}

void lens_ray(const struct camera *camera, float x, float y, float aspect, float direction[3]) {
    float axes[3], right = (2 * x - 1) * aspect, up = 1 - 2 * y, most = camera->fov_y / 2;
    float distance = hypotf(right, up), longitude = (2 * x - 1) * GLM_PIf;
    float angle = camera->lens == LENS_EQUIDISTANT ? most * distance
                                                   : 2 * asinf(fminf(distance * sinf(most / 2), 1));
    float aside = distance > 0 ? sinf(fminf(angle, GLM_PIf)) / distance : 0;
    if (camera->lens == LENS_CUBE) {
        cube_ray(x, y, axes);
    } else if (camera->lens == LENS_EQUIRECTANGULAR) {
        axes[0] = sinf(longitude) * cosf(up * GLM_PI_2f);
        axes[1] = sinf(up * GLM_PI_2f);
        axes[2] = cosf(longitude) * cosf(up * GLM_PI_2f);
    } else {
        axes[0] = aside * right;
        axes[1] = aside * up;
        axes[2] = cosf(fminf(angle, GLM_PIf));
    }
    for (int c = 0; c < 3; c++)
        direction[c] =
            axes[0] * camera->right[c] + axes[1] * camera->up[c] + axes[2] * camera->forward[c];
    vec3_unit(direction);
}

void lens_project(const struct camera *camera, const float direction[3], float aspect,
                  float place[2]) {
    const float axes[3] = {glm_vec3_dot((float *)direction, (float *)camera->right),
                           glm_vec3_dot((float *)direction, (float *)camera->up),
                           glm_vec3_dot((float *)direction, (float *)camera->forward)};
    float aside = hypotf(axes[0], axes[1]), angle = atan2f(aside, axes[2]);
    float most = camera->fov_y / 2;
    float distance =
        camera->lens == LENS_EQUIDISTANT ? angle / most : sinf(angle / 2) / sinf(most / 2);
    if (camera->lens == LENS_CUBE) {
        cube_place(axes, place);
    } else if (camera->lens == LENS_EQUIRECTANGULAR) {
        place[0] = .5F + atan2f(axes[0], axes[2]) / (2 * GLM_PIf);
        place[1] = .5F - atan2f(axes[1], hypotf(axes[0], axes[2])) / GLM_PIf;
    } else {
        distance = aside > 0 ? distance / aside : 0;
        place[0] = .5F + .5F * distance * axes[0] / aspect;
        place[1] = .5F - .5F * distance * axes[1];
    }
}

void lens_default_size(const struct camera *camera, int size[2]) {
    if (!camera_is_wide(camera))
        return;
    size[0] = camera->lens == LENS_CUBE ? 1536 : 800;
    size[1] = camera->lens == LENS_CUBE ? 256 : camera->lens == LENS_EQUIRECTANGULAR ? 400 : 800;
}

bool lens_check_size(const struct camera *camera, int width, int height) {
    return camera->lens != LENS_CUBE || width == 6 * height ||
           error_set("lens=cube: a picture of %dx%d is not six times as wide as high", width,
                     height);
}

bool lens_check(const struct camera *camera) {
    bool is_wide = camera_is_wide(camera), is_distorted = camera_is_distorted(camera);
    bool unit = camera_axis_norm2(camera->right) == 1 && camera_axis_norm2(camera->up) == 1;
    if ((unsigned)camera->lens > LENS_EQUISOLID)
        return error_set("lens: %d is none", (int)camera->lens);
    if (is_distorted && (is_wide || camera->orthographic))
        return error_set("distortion and skew are for pinholes");
    if (is_wide &&
        (camera->orthographic || camera->shift[0] != 0 || camera->shift[1] != 0 || !unit))
        return error_set("lens=%s: the camera is orthographic, or has a shifted lens or pixels "
                         "that are not square",
                         camera_lens_names[camera->lens]);
    if (is_wide && !(camera->fov_y > 0 && camera->fov_y <= 2.00001F * GLM_PIf))
        return error_set("lens=%s: fov: %g is not between 0 and 2 pi radians",
                         camera_lens_names[camera->lens], (double)camera->fov_y);
    return !is_distorted || camera->size[0] == 0 || check_distortion(camera);
}
