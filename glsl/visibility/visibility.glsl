// Which part of a VAL's or VPL's light reaches a point of a surface, by its map. FILTER says how.
#include "visibility/lookup.glsl"
#include "visibility/projection_paraboloid.glsl"
#include "visibility/filter_val.glsl"
#include "visibility/map_views.glsl"

#if FILTER == FILTER_PCSS
#include "visibility/map_in_front.glsl"
#endif

#if FILTER == FILTER_RAY
#include "visibility/ray.glsl"
#elif FILTER == FILTER_TRACED
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
#else

// A cluster fills its bounding rectangle thinly towards the rim: over its side, the least error of taps.
#if FILTER == FILTER_PCSS
const float FILLED = 0.7;
#else
const float FILLED = 1.0;
#endif

float visibility(int map, vec3 position, vec3 normal) {
#if FILTER == FILTER_NONE
    return 1.0;
#else
#if FILTER == FILTER_PCSS
    map = map_in_front(map, position);
#endif
    receiver r;
    if (!project(map_view_at(map), position, normal, r))
        return 1.0;
    return lit(map, r, map_view_at(map).extent * FILLED);
#endif
}

// Of one VPL among those of the map: what all of them have.
float visibility_from(int map, vec3 position, vec3 normal, vec3 light) {
    return visibility(map, position, normal);
}
#endif
