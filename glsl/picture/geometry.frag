// Writes normal, albedo and what is emitted. Holes of alpha masks are not there; nor, for the camera, is the back of a
// single-sided surface, which blocks light but reflects none. HAS_GLOSS: surfaces are not all plain.
// FACETS: what sends light on is each triangle, not the smooth surface that the normals tell of.
#include "lib/octahedral.glsl"
#include "picture/base_color.glsl"

#ifdef HAS_MAPPINGS
in vec2 metal_roughness_uv, emission_uv, normal_uv; // picture/mapped_uv.glsl
#else
#define metal_roughness_uv surface_uv
#define emission_uv surface_uv
#define normal_uv surface_uv
#endif

#ifdef HAS_EMISSION
layout(binding = UNIT_EMISSION) uniform sampler2D emission_texture;
layout(location = TARGET_GBUFFER_EMISSION) out vec4 emitted;
#endif

in vec3 surface_normal;
#ifdef HAS_GLOSS
#include "picture/surface_detail.glsl"
#endif
#ifdef FACETS
#include "picture/facet.glsl"
#endif

#ifndef DEPTH_ONLY
layout(location = TARGET_GBUFFER_NORMAL) out vec2 normal_code;
layout(location = TARGET_GBUFFER_ALBEDO) out vec4 albedo_root;
#ifdef HAS_GLOSS
layout(location = TARGET_GBUFFER_GLOSS) out vec4 gloss_code; // lib/gloss.glsl
#endif
#endif

// Textures and derivatives come before any fragment is dropped: of a neighbour that is gone they are undefined.
void main() {
    vec4 color = base_color();
    bool kept = color.a >= material.alpha_cutoff;
#ifndef DEPTH_ONLY
    vec3 normal = normalize(surface_normal);
#ifdef HAS_GLOSS
    normal = mapped_normal(normal);
#endif
    if (!gl_FrontFacing) {
        if (material.double_sided)
            normal = -normal;
        else
#ifdef LIGHT_VIEW
            color.rgb = vec3(0.0);
#else
            kept = false;
#endif
    }
#ifdef FACETS
    color.rgb = clamp(color.rgb, 0.0, 1.0) * facet_share(normal);
#endif
    normal_code = octahedral_encode(normal);
#endif
#ifdef HAS_EMISSION
    emitted = vec4(material.emission, 1.0);
    if (material.emission_textured)
        emitted.rgb *= texture(emission_texture, emission_uv).rgb;
#ifdef HAS_GLOSS
    if (material.unlit)
        emitted.rgb *= color.rgb;
#endif
#endif
#ifdef HAS_GLOSS
    vec4 gloss;
    color.rgb = diffuse_and_gloss(color.rgb, gloss);
#ifdef LIGHT_VIEW
    color.rgb += evenly_reflected(gloss);
    if (!gl_FrontFacing && !material.double_sided)
        color.rgb = gloss.rgb = vec3(0.0);
#endif
    gloss_code = gloss_encode(gloss);
#endif
#ifndef DEPTH_ONLY
#ifdef FACETS
    albedo_root = vec4(sqrt(max(color.rgb, 0.0)), 1.0);
#else
    albedo_root = vec4(sqrt(clamp(color.rgb, 0.0, 1.0)), 1.0);
#endif
#endif
    if (!kept)
        discard;
}
