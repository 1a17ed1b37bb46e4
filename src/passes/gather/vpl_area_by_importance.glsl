// The area of a VPL of light `index` at a point, where `area` is its area by flux alone.
#include "lib/light_domain.glsl"
#include "passes/lights/vpl_density.glsl"

float vpl_area_at(float area, int index, light l, vec3 position) {
    return vpl_dense_area(area, vpl_density(index, light_domain_place(l, position)));
}
