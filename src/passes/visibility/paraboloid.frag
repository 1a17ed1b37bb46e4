// The exact map depth: where the pixel's true direction meets the caster.
#include "passes/visibility/paraboloid.glsl"
#include "shared/maps.h"
#include "lib/direction.glsl"
#include "shared/material.h"

PASS_BLOCK(paraboloid_params, 16)

flat in vec2 range; // near, 1 / z_far
#ifdef LONG
// Where the pixel's true direction meets a long triangle, of which a polygon around its bent image is drawn.
flat in vec3 plane;     // 1 / r in a direction is their product
flat in vec4 limits[3]; // of the edges
#ifdef MASKED
flat in vec3 uv_slopes[2];
#endif

vec3 caster_normal() {
    return plane;
}

// 0: beside the triangle, or below the map's plane.
float caster_steps(vec4 way) {
    float inside = min(min(dot(limits[0], way), dot(limits[1], way)), dot(limits[2], way));
    return min(inside, way.z - PARABOLOID_LOWEST * way.w) > 0.0 ? 1.0 / dot(plane, way.xyz) : 0.0;
}

#ifdef MASKED
vec2 caster_uv(vec4 way) {
    return vec2(dot(uv_slopes[0], way.xyz), dot(uv_slopes[1], way.xyz)) / dot(plane, way.xyz);
}
#endif
#else
// Where the pixel's true direction meets a short triangle. Between its projected corners the rasteriser draws it
// straight, which it is not in this projection; but what it interpolates linearly, the local position, stays in the
// triangle's plane.
in vec3 local; // a point of the triangle's plane, in the map's frame
#ifdef MASKED
in vec2 surface_uv;
#endif

vec3 caster_normal() {
    return cross(dFdx(local), dFdy(local));
}

// 0: below the map's plane.
float caster_steps(vec4 way) {
    vec3 normal = caster_normal();
    return way.z > 0.0 ? dot(normal, local) / dot(normal, way.xyz) : 0.0;
}

#ifdef MASKED
vec2 caster_uv(vec4 way) {
    return surface_uv;
}
#endif
#endif

#ifdef MASKED
layout(std140, binding = BLOCK_MATERIAL) uniform material_uniforms {
    material_block material;
};
layout(binding = UNIT_BASE_COLOR) uniform sampler2D base_color_texture;

float alpha_at(vec4 way) {
    float alpha = material.base_color.a;
    return material.textured ? alpha * texture(base_color_texture, caster_uv(way)).a : alpha;
}
#endif

#if PLANES
layout(location = TARGET_RESULT) out vec2 normal_code;
#endif

// Corners lie nearer than the caster: fragments behind others need no shading.
layout(depth_greater) out float gl_FragDepth;

// Textures and derivatives come before any fragment is dropped: of a neighbour that is gone they are undefined.
void main() {
    vec4 way = paraboloid_way(gl_FragCoord.xy * params.texel - 1.0);
    float r = caster_steps(way) * way.w;
    bool kept = r > range.x;
#ifdef MASKED
    kept = alpha_at(way) >= material.alpha_cutoff && kept;
#endif
#if PLANES
    normal_code = octahedral_encode(normalize(caster_normal()));
#endif
    gl_FragDepth = (r + params.set_back) * range.y;
    if (!kept)
        discard;
}
