// Lights of a sky whose specular reflection is theirs: suns, and bright lights smaller than the lobe, which few rays of
// the lobe would find. These rays find all other lights (passes/visibility/sky_lobes.frag).
#include "lib/sky.glsl"

bool sky_is_small(int i, float alpha) {
    return length(sky_vector(i)) < 12.0 * alpha * alpha;
}

bool sky_is_lamp(int i, float alpha) {
    return i < SUNS || (i < BRIGHT && sky_is_small(i, alpha));
}
