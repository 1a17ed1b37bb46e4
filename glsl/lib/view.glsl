// A view: depth, positions, and the surfaces of its G-buffer, that of the camera or of a light.
#include "lib/direction.glsl"
#include "shared/view.h"

// The unit axis, along which depth is counted. A place of a pass within its pixel may lean it.
vec3 view_axis(view v) {
    return v.leans ? vec3(v.world_to_clip[0].w, v.world_to_clip[1].w, v.world_to_clip[2].w) : v.forward;
}

// The distance along the view's axis of a reversed depth, metres.
float view_linear_depth(view v, float depth) {
    return v.orthographic ? (1.0 - depth) * v.far : v.near / depth;
}

// The world position at a point of the picture, ndc in [-1, 1], and a distance along the view's axis.
vec3 view_position_at(view v, vec2 ndc, float z) {
    vec3 aside = ndc.x * v.right + ndc.y * v.up;
    float spread = v.orthographic ? 1.0 : z;
    return v.origin + z * v.forward + spread * aside;
}

// The same of a reversed depth.
vec3 view_position(view v, vec2 ndc, float depth) {
    return view_position_at(v, ndc, view_linear_depth(v, depth));
}

// Whether the view shows a position; the texel of a picture of that size that does, else a middle one.
bool view_shows(view v, vec3 position, ivec2 size, out ivec2 texel) {
    vec4 clip = v.world_to_clip * vec4(position, 1.0);
    vec2 ndc = clip.xy / clip.w;
    bool shows = clip.w > 0.0 && all(lessThan(abs(ndc), vec2(1.0)));
    texel = min(ivec2(((shows ? ndc : vec2(0.0)) * 0.5 + 0.5) * vec2(size)), size - 1);
    return shows;
}

// How much the picture shows from its bottom to its top at that depth, metres.
float view_height(view v, float depth) {
    return 2.0 * length(v.up) * (v.orthographic ? 1.0 : view_linear_depth(v, depth));
}

struct surface {
    bool present; // else the pixel sees nothing
    vec3 position, normal;
};

surface surface_fetch(view v, sampler2DArray depths, sampler2DArray normals, ivec3 texel) {
    surface s;
    float depth = texelFetch(depths, texel, 0).r;
    s.present = depth > 0.0;
    vec2 size = vec2(textureSize(depths, 0).xy);
    s.position = view_position(v, (vec2(texel.xy) + 0.5) / size * 2.0 - 1.0, max(depth, 1e-9)); // far where nothing is
    s.normal = octahedral_decode(texelFetch(normals, texel, 0).rg);
    return s;
}

// How much a surface bends towards what is seen beside it: the squared difference of normals; 1 where nothing is.
float surface_bend(vec3 normal, surface beside) {
    vec3 apart = beside.normal - normal;
    return beside.present ? dot(apart, apart) : 1.0;
}

// Albedo is stored as its square root, so that sixteen bits serve dark colours too.
vec3 albedo_fetch(sampler2DArray albedos, ivec3 texel) {
    vec3 root = texelFetch(albedos, texel, 0).rgb;
    return root * root;
}
