// Unit vectors in two numbers of [0, 1]: the octahedron unfolded onto a square.

vec2 octahedral_encode(vec3 n) {
    n /= abs(n.x) + abs(n.y) + abs(n.z);
    vec2 folded = (1.0 - abs(n.yx)) * mix(vec2(-1.0), vec2(1.0), greaterThanEqual(n.xy, vec2(0.0)));
    return (n.z >= 0.0 ? n.xy : folded) * 0.5 + 0.5;
}

// Of any length.
vec3 octahedral_unfold(vec2 code) {
    vec2 p = code * 2.0 - 1.0;
    vec3 n = vec3(p, 1.0 - abs(p.x) - abs(p.y));
    float fold = max(-n.z, 0.0);
    n.xy -= mix(vec2(-fold), vec2(fold), greaterThanEqual(n.xy, vec2(0.0)));
    return n;
}

vec3 octahedral_decode(vec2 code) {
    return normalize(octahedral_unfold(code));
}
