// Decides which environment lights reflect specularly by light sampling: suns, and bright lights smaller than the lobe,
// which few BRDF samples would hit. All others reflect by rays of the lobe (passes/visibility/sky_lobes.frag).
#include "lib/sky.glsl"

bool sky_is_small(int i, float alpha) {
    return length(sky_vector(i)) < 12.0 * alpha * alpha;
}

bool sky_is_sampled_light(int i, float alpha) {
    return i < SUNS || (i < BRIGHT && sky_is_small(i, alpha));
}
