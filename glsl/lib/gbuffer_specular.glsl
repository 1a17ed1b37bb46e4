// How each pixel of the camera's picture reflects towards the camera, but for its diffuse part.
#include "lib/brdf.glsl"
#include "lib/gbuffer.glsl"

layout(binding = UNIT_GBUFFER_SPECULAR) uniform sampler2DArray gbuffer_speculars;

specular_surface gbuffer_specular(surface s, ivec2 pixel) {
    vec4 code = texelFetch(gbuffer_speculars, ivec3(pixel, 0), 0), specular = specular_decode(code);
    vec3 to_eye = camera.orthographic ? -normalize(camera.forward) : normalize(camera.origin - s.position);
    return specular_surface(specular.rgb, specular_grazing(code), specular_alpha(specular.a), s.normal,
                            facing(s.normal, to_eye));
}
