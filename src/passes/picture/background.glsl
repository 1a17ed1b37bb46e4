// The picture for a display, before a background of the user's choice where it has one.
#include "passes/picture/display.glsl"
#include "shared/composite.h"

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
