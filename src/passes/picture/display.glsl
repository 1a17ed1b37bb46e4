// From linear radiance to what a display gets: exposure, tone map, sRGB.
vec3 srgb_encode(vec3 x) {
    return mix(12.92 * x, 1.055 * pow(x, vec3(1.0 / 2.4)) - 0.055, greaterThan(x, vec3(0.0031308)));
}

// The usual fit to the ACES filmic curve [Narkowicz 2015].
vec3 filmic(vec3 x) {
    return x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14);
}

// Light of the display, from 0 to 1.
vec3 shown_light(vec3 radiance, float exposure, bool is_filmic) {
    vec3 exposed = radiance * exposure;
    if (is_filmic)
        exposed = filmic(exposed);
    return clamp(exposed, 0.0, 1.0);
}

vec3 display(vec3 radiance, float exposure, bool is_filmic) {
    return srgb_encode(shown_light(radiance, exposure, is_filmic));
}
