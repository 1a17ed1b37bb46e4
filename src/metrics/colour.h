/* Colour conversions: the sRGB curve, and the opponent spaces of FLIP.
 *
 * RGB is linear with primaries and white of sRGB (ITU-R BT.709, D65). XYZ is divided by the white
 * point, so white is (1, 1, 1) and Y is the relative luminance. */
#ifndef METRICS_COLOUR_H
#define METRICS_COLOUR_H

/* Decode and encode sRGB (IEC 61966-2-1). Encoding clamps to [0, 1]. */
float srgb_decode(float encoded);
float srgb_encode(float linear);

float rgb_luminance(const float rgb[3]);

/* Convert to and from YCxCz, the linearised CIELAB of contrast sensitivity; Y in [-16, 100]. */
void rgb_to_ycxcz(const float rgb[3], float ycxcz[3]);
void ycxcz_to_rgb(const float ycxcz[3], float rgb[3]);

/* Convert to and from CIELAB; L in [0, 100]. */
void rgb_to_lab(const float rgb[3], float lab[3]);
void lab_to_rgb(const float lab[3], float rgb[3]);

static inline float clamp_unit(float value) {
    return value < 0 ? 0 : value > 1 ? 1 : value;
}

#endif
