// The density of VPLs at a place of a light's domain, over their density by flux alone, and their areas. BY_IMPORTANCE: an
// importance map has the densities; else VPLs follow flux alone.
#include "shared/vpl.h"

// Where the lights' domains lie in an importance map.
ivec2 importance_tile(int index) {
    return ivec2(index % VPL_DENSITY_ROW, index / VPL_DENSITY_ROW);
}

ivec2 importance_texel(int index, vec2 place) {
    ivec2 cell = clamp(ivec2(place * float(VPL_DENSITY_SIDE)), ivec2(0), ivec2(VPL_DENSITY_SIDE - 1));
    return importance_tile(index) * VPL_DENSITY_SIDE + cell;
}

// The area of a VPL, where `area` is its area by flux alone. Sparse VPLs keep this area, so that near fields never grow.
float vpl_dense_area(float area, float density) {
    return area / max(density, 1.0);
}

#ifdef BY_IMPORTANCE
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

// The area of a VPL at a place, by its area by flux alone.
float vpl_area_at(float area, int index, vec2 place) {
    return vpl_dense_area(area, vpl_density(index, place));
}
#else
float vpl_area_at(float area, int index, vec2 place) {
    return area;
}
#endif
