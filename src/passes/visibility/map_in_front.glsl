// Which map knows a point that lies behind its VAL's plane, where the VAL's own knows nothing: that of the VAL nearest to it
// which has point and VAL in front, unless the point is nearer still.
#include "passes/visibility/map_views.glsl"

// Over its distance: lower above a plane maps know little.
const float IN_FRONT = 0.05;
// Of more VALs so many are asked, spread over all.
const int IN_FRONT_MOST = 64;

bool is_in_front(map_view v, vec3 position) {
    vec3 off = position - v.center;
    return dot(v.axis, off) > IN_FRONT * length(off);
}

// Its own where it has the point in front, or none is known.
int map_in_front(int map, vec3 position) {
    map_view own = map_view_at(map);
    vec3 from_own = position - own.center;
    float least = dot(from_own, from_own);
    int found = map, most = min(lookup.map_count, IN_FRONT_MOST);
    // A count, and no branch: a software rasteriser executes both sides.
    int asked = is_in_front(own, position) ? 0 : most;
    for (int i = 0; i < asked; i++) {
        int k = i * lookup.map_count / most;
        map_view other = map_view_at(k);
        vec3 to_own = own.center - other.center;
        float distance2 = dot(to_own, to_own);
        bool sees = is_in_front(other, position) && dot(other.axis, to_own) > 0.0 && other.near < MAP_VIEW_EMPTY;
        bool nearer = sees && distance2 < least;
        found = nearer ? k : found;
        least = nearer ? distance2 : least;
    }
    return found;
}
