// What a material's textures say beyond its colour. Who includes it has the material's block, and their uv.
#include "lib/brdf.glsl"
#include "lib/lobe_albedo.glsl"
#include "lib/specular.glsl"

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

// Of that base colour: the albedo of its diffuse part towards a unit direction; the reflectance from straight on and the
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
