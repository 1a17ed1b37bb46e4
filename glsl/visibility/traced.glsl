// Which light reaches a point, by a ray through the scene's triangles.
#include "visibility/bvh.glsl"

// Of one VPL, whatever its map.
float visibility_from(int map, vec3 position, vec3 normal, vec3 light) {
    return is_blocked(position, normal, light) ? 0.0 : 1.0;
}

// Of a VAL's middle.
float visibility(int map, vec3 position, vec3 normal) {
    return visibility_from(map, position, normal, map_view_at(map).center);
}
