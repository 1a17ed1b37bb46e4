// The area of a VPL of light `index` at a place of its domain, where `area` is its area by flux alone.
#include "passes/lights/vpl_density.glsl"

float vpl_area_at(float area, int index, vec2 place) {
    return vpl_dense_area(area, vpl_density(index, place));
}
