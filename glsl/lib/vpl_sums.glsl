// What all VPLs together are like, of those that light reaches.
layout(binding = UNIT_VPL_SUMS) uniform sampler2D vpl_sums; // passes/lights/vpl_sums.vert

// How far apart they are: the geometric mean of the distances of pairs, metres. A few far off hardly count, however far,
// and it moves smoothly with the lights.
float vpl_spread() {
    vec2 pairs = texelFetch(vpl_sums, ivec2(0), 0).xy;
    return exp2(pairs.x / max(pairs.y, 1.0));
}

// Their light, red and green.
vec2 vpl_hue() {
    return texelFetch(vpl_sums, ivec2(0), 0).zw;
}
