// Which part of a VAL's or VPL's light reaches a point of a surface, by its map. FILTER says how.
#include "shared/maps.h"

#if FILTER != FILTER_TRACED
#include "passes/visibility/lookup.glsl"
#include "passes/visibility/projection_paraboloid.glsl"
#include "passes/visibility/filter_val.glsl"
#include "passes/visibility/map_views.glsl"
#endif
#if FILTER == FILTER_PCSS
#include "passes/visibility/map_in_front.glsl"
#endif

#if FILTER == FILTER_RAY
// Whether a VPL's own light reaches a point, by the map of its VAL: a ray from the point to the VPL through what
// the VAL's centre saw [Agrawala et al. 2000]. One centre cannot speak for a wide cluster, but it saw most of what
// lies between: a place of the ray that lies a little behind what the map has there is within a caster.
#include "passes/visibility/depth_maps.glsl"

const int RAY_PLACES = 8;
// Casters are as deep as this, over the point's distance from the centre, or over the ray's length where that is less:
// farther behind them the ray passes where the centre does not see. Over the length it is a little more than from place
// to place, so that no wall is stepped over; beside a VPL what the centre does not see is mostly free.
const float CASTER_DEPTH = 0.4;
const float CASTER_DEPTH_OF_WAY = 0.3;

bool within_caster(float distance, float seen, float deep) {
    return distance > seen && distance < seen + deep;
}

// The map has nothing behind its plane, and little beside it.
bool is_known(vec3 place, float distance) {
    return place.z > 0.05 * distance;
}

// Whether the ray is blocked where it begins.
bool is_receiver_hidden(int map, receiver r, float deep) {
    ivec2 texel = ivec2(r.uv * lookup.map_size);
    float seen = seen_in(map, r, texel), met = seen_from_receiver(map, r, texel, seen);
    return is_known(r.point, r.distance) && within_caster(receiver_distance(r, texel), seen, deep) &&
           met < r.distance * (1.0 - lookup.map_bias);
}

float visibility_from(int map, vec3 position, vec3 normal, vec3 light) {
    map_view v = map_view_at(map);
    receiver r;
    bool projected = project(v, position, normal, r);
    vec3 to_light = paraboloid_local(v, light) - r.point;
    float deep = min(CASTER_DEPTH * r.distance, CASTER_DEPTH_OF_WAY * length(to_light));
    bool hidden = is_receiver_hidden(map, r, deep);
    // A count that is not known beforehand. A software rasteriser executes what a loop holds once even where no pixel
    // enters it: unrolled, that would be all places.
    int places = projected && !hidden ? RAY_PLACES : 0;
    for (int i = 1; i < places && !hidden; i++) {
        vec3 place = r.point + float(i) / float(RAY_PLACES) * to_light;
        float distance = length(place);
        ivec2 texel = ivec2((paraboloid_project(place / distance) * 0.5 + 0.5) * lookup.map_size);
        float compared = distance * (1.0 - lookup.map_bias), seen = seen_in(map, r, texel);
        hidden = is_known(place, distance) && within_caster(compared, seen, deep);
    }
    return projected && hidden ? 0.0 : 1.0;
}
#elif FILTER == FILTER_TRACED
// Which light reaches a point, by a ray through the scene's triangles.
#include "passes/visibility/bvh.glsl"

// Of one VPL, whatever its map.
float visibility_from(int map, vec3 position, vec3 normal, vec3 light) {
    return is_blocked(position, normal, light) ? 0.0 : 1.0;
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
