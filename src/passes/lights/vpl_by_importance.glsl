// VPLs by importance: the third number of a point chooses a light, and the first two are warped so that more VPLs lie where
// importance is greater [Clarberg et al. 2005; Ritschel et al. 2011]. From the light's whole domain down to a cell, the
// halves of each node along u, then along v, are stretched to their fractions. Even points stay even.
#include "passes/lights/importance_parts.glsl"
#include "lib/random.glsl"
#include "passes/lights/vpl_density.glsl"

layout(binding = UNIT_IMPORTANCE_LIGHTS) uniform sampler2D importance_lights;

// `end`: 1 by importance, 2 by flux alone.
int light_of(float number, int end) {
    int last = textureSize(importance_lights, 0).x - 1, index = 0;
    while (index < last && texelFetch(importance_lights, ivec2(index, 0), 0)[end] <= number)
        index++;
    return index;
}

// The density there, over the density by flux alone.
float vpl_choose(vec3 point, out int index, out vec2 place) {
    vec2 within = point.xy;
#ifdef LATER
    // Later light comes by ways that no candidate may have found.
    if (point.z < START_BY_FLUX) {
        index = light_of(point.z / START_BY_FLUX, 2);
        place = within;
        return vpl_density(index, place);
    }
    index = light_of((point.z - START_BY_FLUX) / (1.0 - START_BY_FLUX), 1);
#else
    index = light_of(point.z, 1);
#endif
    ivec2 cell = ivec2(0);
    for (int level = VPL_DENSITY_LEVELS - 2; level >= 0; level--) {
        cell *= 2;
        vec4 parts = importance_parts(index, cell, level);
        int x = take_half(within.x, parts[0] + parts[2], parts[1] + parts[3]);
        cell += ivec2(x, take_half(within.y, parts[x], parts[x + 2]));
    }
    place = (vec2(cell) + within) / float(VPL_DENSITY_SIDE);
    return vpl_density(index, place);
}
