// The pixel's samples, and the planes that pixels see.
#include "shared/antialias.h"
#include "lib/gbuffer.glsl"

// What a point of the picture sees, taken as a plane, across which depth is linear in the picture (shared/view.h).
struct plane {
    float depth;  // there; 0 where it sees nothing
    vec2 slope;   // of the depth, by a pixel along x and y
    float across; // the change of depth that leaves the plane by a pixel's width
    vec3 normal;
};

// At a place of the picture, pixels.
plane plane_at(vec2 place, float depth, vec3 normal) {
    vec2 pixels = 2.0 / vec2(gbuffer_size()), ndc = place * pixels - 1.0;
    vec3 along = vec3(dot(normal, camera.right) * pixels.x, dot(normal, camera.up) * pixels.y,
                      length(camera.right) * pixels.x);
    vec3 ray = camera.orthographic ? camera.forward : camera.forward + ndc.x * camera.right + ndc.y * camera.up;
    float steep = dot(normal, ray);
    steep = steep < 0.0 ? min(steep, -1e-6) : max(steep, 1e-6);
    vec3 change = along / steep * (camera.orthographic ? 1.0 / camera.far : depth);
    return plane(depth, change.xy, abs(change.z), normal);
}

#ifdef HAS_NORMAL_MAPS
// A map bends the normal off the plane.
#include "passes/gather/receiver_facet.glsl"

vec3 pixel_normal(ivec2 pixel) {
    return facet_of(gbuffer_surface(pixel), pixel);
}
#else
vec3 pixel_normal(ivec2 pixel) {
    return octahedral_decode(texelFetch(gbuffer_normals, ivec3(pixel, 0), 0).rg);
}
#endif

plane plane_of(ivec2 pixel) {
    return plane_at(vec2(pixel) + 0.5, gbuffer_depth(pixel), pixel_normal(pixel));
}

// Distance from the plane at a place of the picture, pixels from the plane's point; over `across`.
float off_plane(plane p, vec2 place, float depth) {
    return abs(p.depth + dot(p.slope, place) - depth);
}

layout(binding = UNIT_SAMPLE_DEPTH) uniform sampler2DMSArray sample_depths;

float sample_depth(ivec2 pixel, int i) {
    return texelFetch(sample_depths, ivec3(pixel, i / SAMPLES_PER_LAYER), i % SAMPLES_PER_LAYER).r;
}
