// How each pixel of the camera's picture reflects towards the camera, but for its diffuse part.
#include "lib/brdf.glsl"
#include "lib/gbuffer.glsl"
#include "lib/specular.glsl"

layout(binding = UNIT_GBUFFER_SPECULAR) uniform sampler2DArray gbuffer_speculars;

// Of KHR_materials_specular the G-buffer has no more.
vec3 reflectance_grazing(vec3 f0) {
    return vec3(min(BRDF_GRAZING_OF * max(f0.r, max(f0.g, f0.b)), 1.0));
}

specular_surface gbuffer_specular(surface s, ivec2 pixel) {
    vec4 specular = specular_decode(texelFetch(gbuffer_speculars, ivec3(pixel, 0), 0));
    float roughness = max(specular.a, BRDF_LEAST_ROUGHNESS);
    vec3 to_eye = camera.orthographic ? -normalize(camera.forward) : normalize(camera.origin - s.position);
    return specular_surface(specular.rgb, reflectance_grazing(specular.rgb), roughness * roughness, s.normal,
                            facing(s.normal, to_eye));
}
