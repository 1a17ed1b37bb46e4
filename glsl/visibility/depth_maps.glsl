// Lookups in the paraboloid depth maps.
layout(binding = UNIT_MAP_DEPTH) uniform sampler2DArray depth_maps;

// Whether the map's texel at `uv` sees a point of the plane through q (local) with this normal. Where the
// plane, met in the texel's own direction, is nearer than q, that is compared: it does not shadow itself
// however it is tilted. Where it is farther, q is: in a corner the plane goes on behind the other wall.
bool texel_sees(int map, float z_far, vec3 q, vec3 normal, vec2 uv) {
    ivec2 texel = ivec2(uv * lookup.map_size);
    vec3 direction = paraboloid_direction((vec2(texel) + 0.5) / lookup.map_size * 2.0 - 1.0);
    float facing = dot(normal, direction), r = length(q);
    float plane = facing < -1e-3 ? dot(normal, q) / facing : r;
    // A round wall, seen from inside, bends off its plane by about the squared angle.
    float bend = 2.0 - 2.0 * dot(direction, q) / r;
    float receiver = clamp(plane, r * 0.5, r) * (1.0 - lookup.map_bias - bend);
    return receiver <= texelFetch(depth_maps, ivec3(texel, map), 0).r * z_far;
}
