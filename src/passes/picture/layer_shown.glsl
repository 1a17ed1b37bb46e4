// A layer in a mean of passes and on a display: its weight, and the background that the user chose.
#include "passes/picture/display.glsl"
#include "shared/composite.h"

// Takes the place of the albedo where it is zero, so that the light on a black surface is told.
const float LEAST_WEIGHT = 1e-6;

// What a pass counts for in a layer's mean, by its weight, the share of the pixel that it covers and its
// albedo; likewise sums of them.
vec3 layer_weight(int layer, float weight, float coverage, vec3 albedo) {
    if (layer == LAYER_DIRECT || layer == LAYER_INDIRECT || layer == LAYER_CAUSTIC)
        return albedo + LEAST_WEIGHT * coverage;
    return vec3(layer == LAYER_NORMAL || layer == LAYER_DEPTH ? coverage : weight);
}

// A layer's value at a pixel of which surfaces cover a part. Colours before a background are of that part alone:
// the beauty is light of the whole pixel, other layers are means over surfaces. Light is blended, not sRGB.
vec4 display_before(int layer, vec3 value, float coverage) {
    if (params.background == BACKGROUND_SCENE)
        return vec4(display(value, params.exposure, params.filmic), 1.0);
    if (layer == LAYER_BEAUTY && coverage > 0.0)
        value /= coverage;
    vec3 surface = shown_light(value, params.exposure, params.filmic);
    if (params.background == BACKGROUND_NONE)
        return vec4(srgb_encode(surface), coverage);
    return vec4(srgb_encode(mix(params.background_colour, surface, coverage)), 1.0);
}
