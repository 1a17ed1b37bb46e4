// What a surface reflects that a ray meets, by two texels of its triangle: the albedo's square root, A: 1 where backs reflect,
// too; and the specular part of it (lib/specular.glsl).
layout(binding = UNIT_TRIANGLE_ALBEDOS) uniform samplerBuffer albedos;

vec3 reflected(bvh_hit hit) {
    vec4 code = texelFetch(albedos, 2 * hit.triangle);
    return code.rgb * code.rgb * (hit.back ? code.a : 1.0);
}

vec4 reflected_specular(bvh_hit hit) {
    bool reflects = !hit.back || texelFetch(albedos, 2 * hit.triangle).a > 0.0;
    return reflects ? texelFetch(albedos, 2 * hit.triangle + 1) : vec4(0.0);
}
