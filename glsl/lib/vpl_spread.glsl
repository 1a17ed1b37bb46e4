// How far apart the VPLs are: the geometric mean of the distances of pairs, metres. What no light reaches does
// not count, a few far off hardly do, however far, and it moves smoothly with the lights.
layout(binding = UNIT_VPL_SPREAD) uniform sampler2D vpl_pairs; // lights/vpl_spread.vert

float vpl_spread() {
    vec2 pairs = texelFetch(vpl_pairs, ivec2(0), 0).xy;
    return exp2(pairs.x / max(pairs.y, 1.0));
}
