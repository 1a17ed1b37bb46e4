// A binary lookup in the paraboloid depth map.
layout(binding = 2) uniform sampler2DArray depth_maps;

float visibility(int map, vec3 position) {
    map_view v = views[map];
    vec3 q = paraboloid_local(v, position);
    if (q.z <= 0.0)
        return 1.0; // the map knows nothing there [Dong 2009 Fig. 7]
    float r = length(q);
    vec2 uv = paraboloid_project(q / r) * 0.5 + 0.5;
    float z = texelFetch(depth_maps, ivec3(uv * lookup.map_size, map), 0).r * v.center.w;
    return r - lookup.map_bias <= z ? 1.0 : 0.0;
}
