// Writes normal, albedo and what is emitted. Holes of alpha masks are not there; nor, for the camera, is the back of a
// single-sided surface, which blocks light but reflects none. HAS_SPECULAR: materials are not all plain
// (scene/material.h).
#include "lib/direction.glsl"
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
// What a material's textures say beyond its colour.
#include "lib/brdf.glsl"
#include "lib/lobe_albedo.glsl"

layout(binding = UNIT_METAL_ROUGHNESS) uniform sampler2D metal_roughness_texture;
layout(binding = UNIT_NORMAL_MAP) uniform sampler2D normal_texture;

layout(location = TARGET_GBUFFER_SPECULAR) out vec4 specular_code; // lib/brdf.glsl

// The normal as the material's map turns it. The map's frame is the triangle's: X along u, Y against v, both laid
// onto the normal's plane.
vec3 mapped_normal(vec3 normal) {
    if (!material.normal_textured)
        return normal;
    vec3 turned = texture(normal_texture, normal_uv).xyz * 2.0 - 1.0;
    turned.xy *= material.normal_scale;
    vec3 right = dFdx(surface_position), up = dFdy(surface_position);
    vec2 uv_right = dFdx(normal_uv), uv_up = dFdy(normal_uv);
    float turn = uv_right.x * uv_up.y - uv_up.x * uv_right.y < 0.0 ? -1.0 : 1.0;
    vec3 along_u = turn * (right * uv_up.y - up * uv_right.y);
    vec3 along_v = turn * (up * uv_right.x - right * uv_up.x);
    vec3 tangent = along_u - normal * dot(normal, along_u);
    if (dot(tangent, tangent) == 0.0)
        return normal;
    tangent = normalize(tangent);
    vec3 bitangent = cross(normal, tangent);
    bitangent *= dot(bitangent, along_v) > 0.0 ? -1.0 : 1.0;
    return normalize(turned.x * tangent + turned.y * bitangent + turned.z * normal);
}

// Splits a base colour: the albedo of its diffuse part towards a unit direction, the reflectance from straight on and the
// roughness of its specular part, and the reflectance grazing. The diffuse part has what the lobe leaves of the light, by
// its directional albedo, so that a white dielectric reflects all. The same as reference/brdf.c.
vec3 diffuse_and_specular(vec3 base, float cosine, out vec4 specular, out float grazing) {
    specular = vec4(0.0);
    grazing = 0.0;
    if (material.unlit)
        return vec3(0.0);
    if (material.diffuse)
        return base;
    vec2 metal_rough = vec2(material.metalness, material.roughness);
    vec3 f0 = material.specular_f0;
    if (material.metal_roughness_textured) {
        vec4 read = texture(metal_roughness_texture, metal_roughness_uv);
        if (material.specular_glossiness) {
            metal_rough.y = 1.0 - (1.0 - metal_rough.y) * read.a;
            f0 *= read.rgb;
        } else
            metal_rough *= read.bg;
    }
    float outer_f0 = max(f0.r, max(f0.g, f0.b));
    float f90 = material.specular_glossiness ? min(BRDF_GRAZING_OF * outer_f0, 1.0) : material.specular_f90;
    specular = vec4(mix(f0, base, metal_rough.x), metal_rough.y);
    grazing = mix(f90, 1.0, metal_rough.x);
    float reflected = specular_albedo(vec3(outer_f0), vec3(f90), specular_alpha(metal_rough.y), cosine).r;
    return base * ((1.0 - metal_rough.x) * (1.0 - reflected));
}

bool is_unlit() {
    return material.unlit;
}

// Of the diffuse part, towards the eye or light; of what lights see, all that is reflected of light from there. Writes
// specular_code.
vec3 albedo_of(vec3 base, vec3 normal, vec3 towards, bool of_light, bool is_back) {
    vec4 specular;
    float grazing, cosine = dot(normal, facing(normal, normalize(towards)));
    vec3 albedo = diffuse_and_specular(base, cosine, specular, grazing);
    if (of_light)
        albedo += specular_albedo(specular.rgb, vec3(grazing), specular_alpha(specular.a), cosine);
    if (of_light && is_back)
        albedo = specular.rgb = vec3(0.0);
    specular_code = specular_encode(specular, grazing);
    return albedo;
}
#else
// A material that is diffuse, whatever its textures say.
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
// FACETS: each triangle sends light on, not the smooth surface of the normals, as rays meet it. It receives by the shading
// normal, but its size, to the light and to what it lights, is by its own. Along light paths the two trade places
// [Veach 1997, §5.3].
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
