// What a surface reflects that a ray meets.
layout(binding = UNIT_TRIANGLE_ALBEDOS) uniform samplerBuffer albedos; // A: 1 where backs reflect, too

vec3 reflected(bvh_hit hit) {
    vec4 albedo = texelFetch(albedos, hit.triangle);
    return hit.back ? albedo.rgb * albedo.a : albedo.rgb;
}
