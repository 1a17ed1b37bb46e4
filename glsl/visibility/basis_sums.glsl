// Fourier bases filtered by summed area tables: an area is a box, of whole texels and shares of those at its rim.
#include "visibility/sums.glsl"

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
