// The paraboloid projection of the half space in front of a VAL [Dong 2009 §4.2; Brabec et al. 2002].
#include "shared/maps.h"

// A world vector in the view's own frame: z along the axis.
vec3 paraboloid_rotate(map_view v, vec3 w) {
    vec3 bitangent = cross(v.axis, v.tangent);
    return vec3(dot(w, v.tangent), dot(w, bitangent), dot(w, v.axis));
}

vec3 paraboloid_local(map_view v, vec3 position) {
    return paraboloid_rotate(v, position - v.center);
}

// Where a direction lies, in the unit disc for z >= 0.
vec2 paraboloid_project(vec3 direction) {
    return direction.xy / (1.0 + direction.z);
}

// The direction at a place, and its length.
vec4 paraboloid_way(vec2 p) {
    float p2 = dot(p, p);
    return vec4(2.0 * p, 1.0 - p2, 1.0 + p2);
}

// The unit direction at a place.
vec3 paraboloid_direction(vec2 p) {
    vec4 way = paraboloid_way(p);
    return way.xyz / way.w;
}

// The plane of the light itself is not a caster, and normals are known to a ten thousandth: so much of the distance
// above the plane is left out.
#define PARABOLOID_LOWEST 5e-4

// How far a local place lies above where a map begins.
float paraboloid_above(vec3 q) {
    return q.z - PARABOLOID_LOWEST * length(q);
}

// The rasteriser has depths that are less than a fragment's own by more than rounding, so that it may test them first.
#define LEAST_ROUNDING 1e-3
