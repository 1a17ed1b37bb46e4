#include "shared/view.h"

// The distance along the view's axis of a reversed depth, metres.
float view_linear_depth(view v, float depth) {
    return v.right.w > 0.5 ? (1.0 - depth) * v.forward.w : v.origin.w / depth;
}

// The world position at a point of the picture, ndc in [-1, 1].
vec3 view_position(view v, vec2 ndc, float depth) {
    float z = view_linear_depth(v, depth);
    vec3 aside = ndc.x * v.right.xyz + ndc.y * v.up.xyz;
    float spread = v.right.w > 0.5 ? 1.0 : z;
    return v.origin.xyz + z * v.forward.xyz + spread * aside;
}
