// A binary lookup in the paraboloid depth map.

float visibility(int map, vec3 position, vec3 normal) {
    map_view v = views[map];
    vec3 q = paraboloid_receiver(v, position, normal, lookup.bias, lookup.map_size);
    if (q.z <= 0.0)
        return 1.0; // the map knows nothing there [Dong 2009 Fig. 7]
    vec2 uv = paraboloid_project(normalize(q)) * 0.5 + 0.5;
    return texel_sees(map, v.z_far, q, paraboloid_rotate(v, normal), uv) ? 1.0 : 0.0;
}
