// Writes normal, albedo and what is emitted. Holes of alpha masks are not there; nor, for the camera, is the back of a
// single-sided surface, which blocks light but reflects none. HAS_SPECULAR: materials are not all plain
// (scene/material.h).
#include "lib/octahedral.glsl"
#include "passes/picture/base_color.glsl"

in vec3 surface_normal, surface_position, surface_to_other;

#ifdef LIGHT_VIEW
const bool OF_LIGHT = true;
#else
const bool OF_LIGHT = false;
#endif

#ifdef HAS_MAPPINGS
in vec2 metal_roughness_uv, emission_uv, normal_uv; // passes/picture/geometry.vert
#else
#define metal_roughness_uv surface_uv
#define emission_uv surface_uv
#define normal_uv surface_uv
#endif

#ifdef HAS_SPECULAR
#include "passes/picture/surface_detail.glsl"
#else
// A material that is diffuse, whatever its textures say (passes/picture/surface_detail.glsl).
vec3 mapped_normal(vec3 normal) {
    return normal;
}

bool is_unlit() {
    return false;
}

vec3 albedo_of(vec3 base, vec3 normal, vec3 towards, bool of_light, bool is_back) {
    return base;
}
#endif
#ifdef FACETS
// FACETS: each triangle sends light on, not the smooth surface of the normals. A triangle as rays meet it: it receives by the shading normal, but how large it is, to the light and to what it lights,
// is by its own. Along light paths the two trade places [Veach 1997, §5.3].
// At a facet's horizon the cosines grow apart without a bound.
const float ALBEDO_MOST = 8.0;

// Takes the triangle's own normal in place of the shading normal; returns what it receives by that, over what meets its
// plane: cos_s / cos_g.
float facet_share(inout vec3 normal) {
    vec3 facet = cross(dFdx(surface_position), dFdy(surface_position));
    float shading = dot(normal, surface_to_other), geometric = dot(facet, surface_to_other);
    if (geometric == 0.0)
        return 1.0;
    normal = facet * (inversesqrt(dot(facet, facet)) * sign(geometric));
    return clamp(shading / dot(normal, surface_to_other), 0.0, ALBEDO_MOST);
}

vec3 sent_by_facet(vec3 color, inout vec3 normal) {
    return clamp(color, 0.0, 1.0) * facet_share(normal);
}
#else
// A surface as its normals tell of it.
const float ALBEDO_MOST = 1.0;

vec3 sent_by_facet(vec3 color, inout vec3 normal) {
    return color;
}
#endif

#ifdef HAS_EMISSION
layout(binding = UNIT_EMISSION) uniform sampler2D emission_texture;
layout(location = TARGET_GBUFFER_EMISSION) out vec4 emitted;

void write_emission(vec3 color) {
    emitted = vec4(material.emission, 1.0);
    if (material.emission_textured)
        emitted.rgb *= texture(emission_texture, emission_uv).rgb;
    if (is_unlit())
        emitted.rgb *= color;
}
#else
void write_emission(vec3 color) {
}
#endif

layout(location = TARGET_GBUFFER_NORMAL) out vec2 normal_code;
layout(location = TARGET_GBUFFER_ALBEDO) out vec4 albedo_root;

// Textures and derivatives come before any fragment is dropped: of a neighbour that is gone they are undefined.
void main() {
    vec4 color = base_color();
    vec3 normal = mapped_normal(normalize(surface_normal));
    bool is_back = !gl_FrontFacing && !material.double_sided;
    bool kept = color.a >= material.alpha_cutoff && (OF_LIGHT || !is_back);
    if (!gl_FrontFacing && material.double_sided)
        normal = -normal;
    if (is_back)
        color.rgb = vec3(0.0);
    vec3 sent = sent_by_facet(color.rgb, normal);
    normal_code = octahedral_encode(normal);
    write_emission(sent);
    vec3 albedo = albedo_of(sent, normal, surface_to_other, OF_LIGHT, is_back);
    albedo_root = vec4(sqrt(clamp(albedo, 0.0, ALBEDO_MOST)), 1.0);
    if (!kept)
        discard;
}
