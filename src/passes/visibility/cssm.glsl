// Convolution soft shadow maps [Dong 2009 §4.1-4.2; Dong 2011 ch. 5].
//
// Distances are map depths: metres over the unit. With the argument a that the map's range makes of them, and b of
// the receiver's, the blocked fraction of a filter w is
//     s(b) = 1/2 + 2 sum_k (sin(c_k b) [w*cos c_k a] - cos(c_k b) [w*sin c_k a]) / c_k
// and the mean argument of the blockers is the same expansion of a, over s (eq. 5.10, 5.11).
#include "passes/visibility/series.glsl"

#ifdef BASIS_SUMS
// Fourier bases filtered by summed area tables: an area is a box, of whole texels and shares of those at its rim.
#include "passes/visibility/sums.glsl"

struct basis_area {
    ivec4 x, y; // edges of three cells a side
    vec3 width, height;
};

// Sums are told apart in integers, and only then weighted: what is between two of them would be rounded away.
vec4 mean_of_table(basis_area area, int map, int table) {
    vec4 sum = vec4(0.0);
    uvec4 below[4];
    for (int j = 0; j < 4; j++) {
        uvec4 left = uvec4(0u), below_left = uvec4(0u);
        for (int i = 0; i < 4; i++) {
            uvec4 corner = texelFetch(sums, ivec3(area.x[i], area.y[j], table * MAP_COUNT + map), 0);
            if (i > 0 && j > 0)
                sum += vec4(corner - left - below[i] + below_left) * (area.width[i - 1] * area.height[j - 1]);
            below_left = below[i];
            below[i] = corner;
            left = corner;
        }
    }
    float texels = dot(area.width, vec3(area.x.yzw - area.x.xyz)) * dot(area.height, vec3(area.y.yzw - area.y.xyz));
    return sum / (texels * SUM_BASIS_ONE) * 2.0 - 1.0;
}

vec4 mean_cos(basis_area area, int map, int group) {
    return mean_of_table(area, map, group);
}

vec4 mean_sin(basis_area area, int map, int group) {
    return mean_of_table(area, map, BASIS_GROUPS + group);
}

vec4 mean_z_cos(basis_area area, int map, int group) {
    return mean_of_table(area, map, 2 * BASIS_GROUPS + group);
}

vec4 mean_z_sin(basis_area area, int map, int group) {
    return mean_of_table(area, map, 3 * BASIS_GROUPS + group);
}

float mean_z(basis_area area, int map) {
    return mean_of_table(area, map, 4 * BASIS_GROUPS).r;
}

// No narrower than a texel.
basis_area basis_area_of(vec4 window) {
    vec2 high = min(window.zw * lookup.map_size, lookup.map_size - 0.01);
    vec2 low = max(min(window.xy * lookup.map_size, high - 1.0), 0.0), first = floor(low), last = floor(high);
    basis_area area;
    area.x = ivec4(first.x, first.x + 1.0, last.x, last.x + 1.0);
    area.y = ivec4(first.y, first.y + 1.0, last.y, last.y + 1.0);
    area.width = vec3(first.x + 1.0 - low.x, 1.0, high.x - last.x);
    area.height = vec3(first.y + 1.0 - low.y, 1.0, high.y - last.y);
    return area;
}
#else
// Fourier bases filtered by MIP maps: an area is a place and a level.
layout(binding = UNIT_BASIS_COS) uniform sampler2DArray basis_cos;
layout(binding = UNIT_BASIS_SIN) uniform sampler2DArray basis_sin;
layout(binding = UNIT_BASIS_Z_COS) uniform sampler2DArray basis_z_cos;
layout(binding = UNIT_BASIS_Z_SIN) uniform sampler2DArray basis_z_sin;
layout(binding = UNIT_BASIS_Z) uniform sampler2DArray basis_z;

struct basis_area {
    vec2 uv;
    float lod;
};

vec3 basis_place(basis_area area, int map, int group) {
    return vec3(area.uv, group * MAP_COUNT + map);
}

vec4 mean_cos(basis_area area, int map, int group) {
    return textureLod(basis_cos, basis_place(area, map, group), area.lod) * 2.0 - 1.0;
}

vec4 mean_sin(basis_area area, int map, int group) {
    return textureLod(basis_sin, basis_place(area, map, group), area.lod) * 2.0 - 1.0;
}

vec4 mean_z_cos(basis_area area, int map, int group) {
    return textureLod(basis_z_cos, basis_place(area, map, group), area.lod);
}

vec4 mean_z_sin(basis_area area, int map, int group) {
    return textureLod(basis_z_sin, basis_place(area, map, group), area.lod);
}

float mean_z(basis_area area, int map) {
    return textureLod(basis_z, vec3(area.uv, map), area.lod).r;
}

// The level whose texel is so much narrower than the window that what is between two texels comes out right.
basis_area basis_area_of(vec4 window) {
    vec2 texels = (window.zw - window.xy) * lookup.map_size;
    return basis_area(0.5 * (window.xy + window.zw), max(0.5 * log2(texels.x * texels.y) - 0.5, 0.0));
}
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
