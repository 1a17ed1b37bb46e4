// Gives each sample of the pixel to the neighbour whose surface it lies on [Chajdas et al. 2011 §3].
#include "lib/gbuffer.glsl"
#include "picture/picks.glsl"
#include "shared/antialias.h"

layout(binding = UNIT_SAMPLE_DEPTH) uniform sampler2DMSArray sample_depths;

layout(location = TARGET_RESULT) out uvec2 picks;

// On its own plane a sample stays within this, over the pixel's width there.
const float PLANE_TOLERANCE = 0.1;
// A neighbour far off in depth along its own plane is less likely than a near one: a silhouette's plane
// holds the line of sight, and with it whatever lies behind.
const float APART_WEIGHT = 0.1;

float sample_depth(ivec2 pixel, int i) {
    return texelFetch(sample_depths, ivec3(pixel, i / SAMPLES_PER_LAYER), i % SAMPLES_PER_LAYER).r;
}

// What a pixel sees, taken as a plane, across which depth is linear in the picture (shared/view.h).
struct plane {
    float depth;  // at the pixel's centre; 0 where it sees nothing
    vec2 slope;   // of the depth, by a pixel along x and y
    float across; // the change of depth that leaves the plane by a pixel's width
};

plane plane_of(ivec2 pixel) {
    float depth = gbuffer_depth(pixel);
    surface s = gbuffer_surface(pixel);
    vec2 pixels = 2.0 / vec2(gbuffer_size());
    vec3 along = vec3(dot(s.normal, camera.right) * pixels.x, dot(s.normal, camera.up) * pixels.y,
                      length(camera.right) * pixels.x);
    vec3 ray = (s.position - camera.origin) * (depth / camera.near); // forward + aside
    float steep = dot(s.normal, camera.orthographic ? camera.forward : ray);
    steep = steep < 0.0 ? min(steep, -1e-6) : max(steep, 1e-6);
    vec3 change = along / steep * (camera.orthographic ? 1.0 / camera.far : depth);
    return plane(depth, s.present ? change.xy : vec2(0.0), s.present ? abs(change.z) : 0.0);
}

// Distance from the plane at a place of the picture, pixels from the pixel's centre; over `across`.
float off_plane(plane p, vec2 place, float depth) {
    return abs(p.depth + dot(p.slope, place) - depth);
}

// How far two depths lie from each other, over the pixel's width there.
float apart(float a, float b) {
    float width = 2.0 * length(camera.right) / float(gbuffer_size().x);
    return (camera.orthographic ? abs(a - b) * camera.far : abs(a / max(b, 1e-30) - 1.0)) / width;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy), last = gbuffer_size() - 1;
    plane center = plane_of(pixel);
    float depth[SAMPLES], least[SAMPLES];
    uint best[SAMPLES];
    bool edge = false;
    for (int i = 0; i < SAMPLES; i++) {
        depth[i] = sample_depth(pixel, i);
        least[i] = 1e30;
        best[i] = PICK_NOTHING;
        float off = off_plane(center, params.places[i].xy, depth[i]);
        edge = edge || off > PLANE_TOLERANCE * center.across;
    }
    // Most pixels have no edge, and a loop that no pixel enters is left where a branch would cost.
    uint picks_to_try = edge ? 9u : 0u;
    for (uint pick = 0u; pick < picks_to_try; pick++) {
        ivec2 offset = clamp(pixel + pick_offset(pick), ivec2(0), last) - pixel;
        plane p = plane_of(pixel + offset);
        for (int i = 0; i < SAMPLES; i++) {
            vec2 place = params.places[i].xy - vec2(offset);
            float off = off_plane(p, place, depth[i]) / p.across +
                        APART_WEIGHT * apart(p.depth, depth[i]);
            bool better = p.depth > 0.0 && depth[i] > 0.0 && off < least[i];
            least[i] = better ? off : least[i];
            best[i] = better ? pick : best[i];
        }
    }
    picks = uvec2(0u);
    for (int i = 0; i < SAMPLES; i++)
        picks[i / 8] |= (edge ? best[i] : 0u) << uint(4 * (i % 8));
}
