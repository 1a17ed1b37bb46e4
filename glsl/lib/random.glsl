// Two numbers from 0 to 1, the same ones for the same three integers [Jarzynski and Olano 2020, pcg3d].
vec2 random_of(uvec3 seed) {
    uvec3 v = seed * 1664525u + 1013904223u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v ^= v >> 16u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    return vec2(v.xy >> 8u) / 16777216.0;
}
