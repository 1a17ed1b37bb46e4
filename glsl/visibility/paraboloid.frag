// The exact map depth. Between the projected corners of a triangle the rasteriser draws it straight,
// which it is not in this projection; but what it interpolates linearly, the local position, stays in
// the triangle's plane. That plane, met by the pixel's true direction, gives the depth.
#include "visibility/paraboloid.glsl"
#include "shared/paraboloid.h"
#if PLANES
#include "lib/octahedral.glsl"
#endif
#ifdef MASKED
#include "shared/material.h"
#endif

in vec3 local;      // a point of the triangle's plane, in the map's frame
flat in vec2 range; // near, z_far, metres
#ifdef LONG
flat in vec3 plane; // of a long triangle that is drawn in pieces: its normal, not unit
#endif

#ifdef MASKED
layout(std140, binding = BLOCK_MATERIAL) uniform material_uniforms {
    material_block material;
};
layout(binding = UNIT_BASE_COLOR) uniform sampler2D base_color_texture;

in vec2 surface_uv;
#endif

#if PLANES
layout(location = TARGET_RESULT) out vec2 normal_code;
#endif

void main() {
#ifdef MASKED
    float alpha = material.base_color.a;
    if (material.textured)
        alpha *= texture(base_color_texture, surface_uv).a;
    if (alpha < material.alpha_cutoff)
        discard;
#endif
    vec3 direction = paraboloid_direction(gl_FragCoord.xy / params.map_size * 2.0 - 1.0);
#ifdef LONG
    vec3 normal = plane; // derivatives over a small piece lose too many digits
#else
    vec3 normal = cross(dFdx(local), dFdy(local));
#endif
    float facing = dot(normal, direction);
    float r = dot(normal, local) / facing;
    if (!(r > range.x && direction.z > 0.0))
        discard;
    gl_FragDepth = (r + params.set_back) / range.y;
#if PLANES
    normal_code = octahedral_encode(normalize(normal));
#endif
}
