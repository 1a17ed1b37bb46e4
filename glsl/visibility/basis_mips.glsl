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
