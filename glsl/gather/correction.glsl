// How much more or less light arrives than lookups have it, by VAL and by where it arrives in the picture
// (passes/gather/correction.h).
layout(binding = UNIT_CORRECTION) uniform sampler2DArray correction; // R: of lookups by pixels, G: by blocks

// place: in the picture, from 0 to 1.
vec2 correction_at(int map, vec2 place) {
    return texture(correction, vec3(place, float(map))).rg;
}

// A veil over the visibility, which black makes darker and white lighter: its colour, times alpha, and alpha.
vec2 correction_veil(float amount) {
    return vec2(max(amount, 0.0), abs(amount));
}

float corrected(float visible, float amount) {
    vec2 veil = correction_veil(amount);
    return visible * (1.0 - veil.y) + veil.x;
}
