// Maps of depth, compared texel by texel.
layout(binding = UNIT_MAP_DEPTH) uniform sampler2DArray depth_maps;

// The distance that a texel's middle sees. Maps have nothing beyond their rim.
float seen_in(int map, receiver r, ivec2 texel) {
    ivec3 place = ivec3(clamp(texel, ivec2(0), ivec2(lookup.map_size) - 1), map);
    return map_depth(r, texelFetch(depth_maps, place, 0).r) * r.unit;
}

bool texel_sees(int map, receiver r, ivec2 texel) {
    return receiver_distance(r, texel) <= seen_in(map, r, texel);
}

// Where what a texel's middle sees is met in the receiver's own direction: in a corner that is the other wall, which
// lies behind the receiver there. Its slope is that towards the texels on the far side of the middle, within what no
// edge between two surfaces has.
float seen_from_receiver(int map, receiver r, ivec2 texel, float seen) {
    vec2 aside = r.uv * lookup.map_size - vec2(texel) - 0.5;
    ivec2 away = ivec2(aside.x < 0.0 ? 1 : -1, aside.y < 0.0 ? 1 : -1);
    vec2 beside = vec2(seen_in(map, r, texel + ivec2(away.x, 0)), seen_in(map, r, texel + ivec2(0, away.y)));
    // Over a plane the inverse of depth is nearly linear.
    vec2 slope = clamp(seen / beside - 1.0, -0.2, 0.2);
    return seen / max(1.0 - dot(slope, abs(aside)), 1e-3);
}
