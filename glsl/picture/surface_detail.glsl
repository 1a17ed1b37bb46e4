// What a material's textures say beyond its colour. Who includes it has the material's block, and their uv.
#include "lib/specular.glsl"
#include "shared/brdf.h"

layout(binding = UNIT_METAL_ROUGHNESS) uniform sampler2D metal_roughness_texture;
layout(binding = UNIT_NORMAL_MAP) uniform sampler2D normal_texture;

layout(location = TARGET_GBUFFER_SPECULAR) out vec4 specular_code; // lib/specular.glsl

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

// Of that base colour: the albedo of its diffuse part, and the reflectance from straight on and the roughness of its
// specular part. The same as reference/brdf.c.
vec3 diffuse_and_specular(vec3 base, out vec4 specular) {
    specular = vec4(0.0);
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
    return base * ((1.0 - metal_rough.x) * (1.0 - mix(outer_f0, f90, BRDF_MEAN_SCHLICK)));
}

bool is_unlit() {
    return material.unlit;
}

// Of the diffuse part; of what lights see, with what the rest reflects, as if evenly. Writes specular_code.
vec3 albedo_of(vec3 base, bool of_light, bool is_back) {
    vec4 specular;
    vec3 albedo = diffuse_and_specular(base, specular);
    if (of_light)
        albedo += evenly_reflected(specular);
    if (of_light && is_back)
        albedo = specular.rgb = vec3(0.0);
    specular_code = specular_encode(specular);
    return albedo;
}
