// The density of VPLs at a place of a light's domain, over their density by flux alone.
#include "passes/lights/importance_cells.glsl"
#include "passes/lights/vpl_dense_area.glsl"

layout(binding = UNIT_VPL_DENSITY) uniform sampler2D vpl_densities;

#ifdef LATER
// Fraction of starts of paths that follow flux alone: no path has more than its inverse times an even share of light.
const float START_BY_FLUX = 0.5;
#endif

float vpl_density(int index, vec2 place) {
    float density = texelFetch(vpl_densities, importance_texel(index, place), 0).r;
#ifdef LATER
    return mix(density, 1.0, START_BY_FLUX);
#else
    return density;
#endif
}
