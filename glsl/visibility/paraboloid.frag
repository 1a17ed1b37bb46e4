// The exact map depth: where the pixel's true direction meets the caster.
#include "visibility/paraboloid.glsl"
#include "shared/paraboloid.h"
#include "lib/octahedral.glsl"
#include "shared/material.h"

flat in vec2 range; // near, 1 / z_far
#ifdef LONG
#include "visibility/paraboloid_long.glsl"
#else
#include "visibility/paraboloid_short.glsl"
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
