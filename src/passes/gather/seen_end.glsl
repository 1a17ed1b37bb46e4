// Whether the camera sees a lit surface that other pixels reflect: then the frame has its direct light.
#include "lib/gbuffer_specular.glsl"

// The camera sees a surface where it lies within so many pixels of the pixel's plane, and faces alike.
const float SEEN_PIXELS = 3.0;
const float SEEN_COSINE = 0.5;
// Surfaces that reflect more than this as a mirror does send other light elsewhere.
const float SEEN_F0_MAX = 0.25;

bool camera_sees(vec3 position, vec3 normal, out ivec2 pixel) {
    bool inside = view_shows(camera, position, gbuffer_size(), pixel);
    surface seen = gbuffer_surface(pixel);
    float wide = view_height(camera, gbuffer_depth(pixel)) / float(gbuffer_size().y);
    vec3 f0 = specular_decode(texelFetch(gbuffer_speculars, ivec3(pixel, 0), 0)).rgb;
    return inside && seen.present && dot(seen.normal, normal) > SEEN_COSINE &&
           distance(seen.position, position) < SEEN_PIXELS * wide &&
           max(f0.r, max(f0.g, f0.b)) < SEEN_F0_MAX;
}
