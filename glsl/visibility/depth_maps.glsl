// Maps of depth, compared texel by texel.
layout(binding = UNIT_MAP_DEPTH) uniform sampler2DArray depth_maps;

bool texel_sees(int map, receiver r, ivec2 texel) {
    float stored = texelFetch(depth_maps, ivec3(texel, map), 0).r;
    return receiver_distance(r, texel) <= map_depth(r, stored) * r.unit;
}
