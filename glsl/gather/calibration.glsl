// How much more or less light arrives than lookups have it, by VAL and by where it arrives in the picture
// (passes/gather/calibration.h).
layout(binding = UNIT_CALIBRATION) uniform sampler2DArray calibration; // R: of lookups by pixels, G: by blocks

// place: in the picture, from 0 to 1.
vec2 calibration_at(int map, vec2 place) {
    return texture(calibration, vec3(place, float(map))).rg;
}

// A veil over the visibility, which black makes darker and white lighter: its colour, times alpha, and alpha.
vec2 calibration_veil(float gain) {
    return vec2(max(gain, 0.0), abs(gain));
}

float calibrated(float visible, float gain) {
    vec2 veil = calibration_veil(gain);
    return visible * (1.0 - veil.y) + veil.x;
}
