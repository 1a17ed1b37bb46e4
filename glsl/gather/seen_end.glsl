// Whether the camera sees a lit surface that other pixels reflect: then the frame has its direct light.
#include "lib/gbuffer_specular.glsl"

// The camera sees a surface where it lies within so many pixels of the pixel's plane, and faces alike.
const float SEEN_PIXELS = 3.0;
const float SEEN_COSINE = 0.5;
// Surfaces that reflect more than this as a mirror does send other light elsewhere.
const float SEEN_F0_MAX = 0.25;

bool camera_sees(vec3 position, vec3 normal, out ivec2 pixel) {
    vec4 clip = camera.world_to_clip * vec4(position, 1.0);
    vec2 ndc = clip.xy / clip.w;
    ivec2 size = gbuffer_size();
    bool inside = clip.w > 0.0 && all(lessThan(abs(ndc), vec2(1.0)));
    pixel = min(ivec2(((inside ? ndc : vec2(0.0)) * 0.5 + 0.5) * vec2(size)), size - 1);
    surface seen = gbuffer_surface(pixel);
    float wide = view_height(camera, gbuffer_depth(pixel)) / float(size.y);
    vec3 f0 = specular_decode(texelFetch(gbuffer_speculars, ivec3(pixel, 0), 0)).rgb;
    return inside && seen.present && dot(seen.normal, normal) > SEEN_COSINE &&
           distance(seen.position, position) < SEEN_PIXELS * wide &&
           max(f0.r, max(f0.g, f0.b)) < SEEN_F0_MAX;
}
