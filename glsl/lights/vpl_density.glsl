// The density of VPLs at a place of a light's domain, over their density by flux alone.
#include "lights/importance_cells.glsl"
#include "lights/vpl_dense_area.glsl"

layout(binding = UNIT_VPL_DENSITY) uniform sampler2D vpl_densities;

float vpl_density(int index, vec2 place) {
    return texelFetch(vpl_densities, importance_texel(index, place), 0).r;
}
