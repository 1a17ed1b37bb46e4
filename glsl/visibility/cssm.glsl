// Convolution soft shadow maps [Dong 2009 §4.1-4.2; Dong 2011 ch. 5].
//
// Distances are map depths: metres over the unit. With the argument a that the map's range makes of them, and b of
// the receiver's, the blocked fraction of a filter w is
//     s(b) = 1/2 + 2 sum_k (sin(c_k b) [w*cos c_k a] - cos(c_k b) [w*sin c_k a]) / c_k
// and the mean argument of the blockers is the same expansion of a, over s (eq. 5.10, 5.11).
#include "visibility/series.glsl"

#ifdef BASIS_SUMS
#include "visibility/basis_sums.glsl"
#else
#include "visibility/basis_mips.glsl"
#endif

const float PI = 3.14159265358979;
const float BLOCKED_MIN = 0.02; // below it the division by s is noise: lit

// sin and cos of c_k b for the four terms of a group, and 2 / c_k (0 beyond the last term).
void terms(int group, float b, out vec4 s, out vec4 c, out vec4 weight) {
    vec4 k = vec4(0.0, 1.0, 2.0, 3.0) + float(4 * group);
    vec4 frequency = PI * (2.0 * k + 1.0);
    s = sin(frequency * b);
    c = cos(frequency * b);
    weight = mix(vec4(0.0), 2.0 / frequency, lessThan(k, vec4(BASIS_TERMS)));
}

float blocked_fraction(basis_area area, int map, float b) {
    float sum = 0.5;
    for (int group = 0; group < BASIS_GROUPS; group++) {
        vec4 s, c, weight;
        terms(group, b, s, c, weight);
        sum += dot(weight, s * mean_cos(area, map, group) - c * mean_sin(area, map, group));
    }
    return sum;
}

// The mean argument of what blocks; negative where (almost) nothing does.
float blocker_argument(basis_area area, int map, float b) {
    float blocked = blocked_fraction(area, map, b);
    if (blocked < BLOCKED_MIN)
        return -1.0;
    float sum = 0.5 * mean_z(area, map);
    for (int group = 0; group < BASIS_GROUPS; group++) {
        vec4 s, c, weight;
        terms(group, b, s, c, weight);
        sum += dot(weight, s * mean_z_cos(area, map, group) - c * mean_z_sin(area, map, group));
    }
    return max(sum / blocked, 0.0);
}
