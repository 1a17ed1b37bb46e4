// Directional albedo of a pixel's specular part. The blur divides radiance by it, so that textures stay sharp.
#include "lib/gbuffer_specular.glsl"
#include "lib/lobe_albedo.glsl"

vec3 pixel_reflects(ivec2 pixel) {
    specular_surface s = gbuffer_specular(gbuffer_surface(pixel), pixel);
    return max(specular_albedo(s.f0, s.f90, s.alpha, dot(s.normal, s.to_eye)), 1e-3);
}
