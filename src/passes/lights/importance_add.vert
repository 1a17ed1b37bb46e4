// A candidate lands on its cell with its value over the density of candidates there: of all rounds so far, which is the
// balance heuristic [Veach 1997, §9.2.2].
#include "lib/vpl_shares.glsl"
#include "shared/importance_map.h"
#include "passes/lights/vpl_density.glsl"
#ifdef SKY_RAYS
#include "passes/lights/sky_pieces.glsl"
#endif

layout(binding = UNIT_CANDIDATES) uniform sampler2D candidates;

flat out vec4 value; // and count

void main() {
    vec4 candidate = texelFetch(candidates, ivec2(gl_VertexID % params.side, gl_VertexID / params.side), 0);
    int index = int(candidate.z);
    float density = 1.0 / max(float(light_count) * light_fraction(index, params.vpls), 1e-30);
#ifdef SKY_RAYS
    density *= sky_door_density(index, candidate.xy);
#endif
#ifdef BY_IMPORTANCE
    density += vpl_density(index, candidate.xy);
#endif
    value = vec4(candidate.w / density, 1.0, 0.0, 0.0);
    vec2 ndc = (vec2(importance_texel(index, candidate.xy)) + 0.5) / vec2(params.tiles * VPL_DENSITY_SIDE) * 2.0 - 1.0;
    gl_Position = value.x > 0.0 ? vec4(ndc, 0.0, 1.0) : vec4(0.0, 0.0, 2.0, 1.0);
}
