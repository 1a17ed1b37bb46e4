// Of a group of lights one, taken by how much it gives, tests visibility for all: on average each counts as if it had
// tested its own.
#include "lib/random.glsl"

// A number of [0, 1) for a pixel's first group: pixels side by side have numbers far apart. turn: from pass to pass.
float group_random(ivec2 pixel, float turn) {
    uvec2 turns = uvec2(pixel) * LATTICE_PLASTIC;
    return fract(lattice_number(turns.x + turns.y) + turn);
}

// For the next group, as one number has no digits for more.
float group_random_next(float random) {
    return fract(random + 0.6180339887);
}

// What arrives of the group's sum, by its strength, by what its representative gives and by whether that arrives.
vec3 group_light(vec3 sum, float strength, vec3 own, float visible) {
#if RECEIVERS == RECEIVERS_ADAPTIVE
    return sum * visible;
#else
    // In the hue of the representative, which no group's is in all of its lights: less even, and right on the mean.
    vec3 hidden = own * (strength / max(dot(own, vec3(1.0)), 1e-30));
    return sum - (1.0 - visible) * hidden;
#endif
}
