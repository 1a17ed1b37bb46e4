#include "metrics/colour.h"

#include <math.h>

/* sRGB's primaries, each row divided by the white's component so that it sums to 1. */
static const float rgb_to_xyz[3][3] = {{0.433895389f, 0.376242373f, 0.189862239f},
                                       {0.212636822f, 0.715182982f, 0.072180196f},
                                       {0.017752423f, 0.109465629f, 0.872781948f}};
/* Its inverse. */
static const float xyz_to_rgb[3][3] = {{3.080341988f, -1.537398969f, -0.542943019f},
                                       {-0.921178396f, 1.875929984f, 0.045248412f},
                                       {0.052881293f, -0.204011206f, 1.151129913f}};

static void multiply(const float matrix[3][3], const float in[3], float out[3]) {
    for (int i = 0; i < 3; i++)
        out[i] = matrix[i][0] * in[0] + matrix[i][1] * in[1] + matrix[i][2] * in[2];
}

float srgb_decode(float encoded) {
    return encoded <= 0.04045f ? encoded / 12.92f : powf((encoded + 0.055f) / 1.055f, 2.4f);
}

float srgb_encode(float linear) {
    float value = clamp_unit(linear);
    return value <= 0.0031308f ? value * 12.92f : 1.055f * powf(value, 1 / 2.4f) - 0.055f;
}

float rgb_luminance(const float rgb[3]) {
    return rgb_to_xyz[1][0] * rgb[0] + rgb_to_xyz[1][1] * rgb[1] + rgb_to_xyz[1][2] * rgb[2];
}

void rgb_to_ycxcz(const float rgb[3], float ycxcz[3]) {
    float xyz[3];
    multiply(rgb_to_xyz, rgb, xyz);
    ycxcz[0] = 116 * xyz[1] - 16;
    ycxcz[1] = 500 * (xyz[0] - xyz[1]);
    ycxcz[2] = 200 * (xyz[1] - xyz[2]);
}

void ycxcz_to_rgb(const float ycxcz[3], float rgb[3]) {
    float y = (ycxcz[0] + 16) / 116;
    multiply(xyz_to_rgb, (const float[]){y + ycxcz[1] / 500, y, y - ycxcz[2] / 200}, rgb);
}

/* CIELAB's cube root with a straight foot below (6/29)^3, and its inverse. */
static float lab_compress(float value) {
    const float foot = 6.0f / 29;
    return value > foot * foot * foot ? cbrtf(value) : value / (3 * foot * foot) + 4.0f / 29;
}

static float lab_expand(float value) {
    const float foot = 6.0f / 29;
    return value > foot ? value * value * value : 3 * foot * foot * (value - 4.0f / 29);
}

void rgb_to_lab(const float rgb[3], float lab[3]) {
    float xyz[3];
    multiply(rgb_to_xyz, rgb, xyz);
    float fx = lab_compress(xyz[0]), fy = lab_compress(xyz[1]), fz = lab_compress(xyz[2]);
    lab[0] = 116 * fy - 16;
    lab[1] = 500 * (fx - fy);
    lab[2] = 200 * (fy - fz);
}

void lab_to_rgb(const float lab[3], float rgb[3]) {
    float fy = (lab[0] + 16) / 116;
    float fx = fy + lab[1] / 500, fz = fy - lab[2] / 200;
    multiply(xyz_to_rgb, (const float[]){lab_expand(fx), lab_expand(fy), lab_expand(fz)}, rgb);
}
