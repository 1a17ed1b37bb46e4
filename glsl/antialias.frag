// Gives each sample of the pixel to the neighbour whose surface it lies on [Chajdas et al. 2011 §3].
#include "lib/picks.glsl"
#include "lib/surface.glsl"
#include "shared/params.h"

layout(std140, binding = BLOCK_VIEW) uniform view_uniforms {
    view camera;
};
layout(std140, binding = BLOCK_PASS) uniform pass_uniforms {
    antialias_params params;
};
layout(binding = 0) uniform sampler2DArray depths;
layout(binding = 1) uniform sampler2DArray normals;
layout(binding = 2) uniform sampler2DMSArray sample_depths;

layout(location = 0) out uvec2 picks;

// On its own plane a sample stays within this, over the pixel's width there.
const float PLANE_TOLERANCE = 0.1;
// A neighbour far along its own plane is less likely than a near one: a silhouette's plane holds the
// line of sight, and with it whatever lies behind.
const float APART_WEIGHT = 0.1;

float sample_depth(ivec2 pixel, int i) {
    return texelFetch(sample_depths, ivec3(pixel, i / SAMPLES_PER_LAYER), i % SAMPLES_PER_LAYER).r;
}

// Depth is linear across the picture of a plane (shared/view.h): its change by a pixel along x and y,
// and, as z, the change that leaves the plane by the pixel's width.
vec3 depth_change(surface s, float depth) {
    vec2 pixels = 2.0 / vec2(textureSize(depths, 0).xy);
    bool orthographic = camera.right.w > 0.5;
    float width = pixels.x * length(camera.right.xyz);
    vec3 along = vec3(dot(s.normal, camera.right.xyz) * pixels.x,
                      dot(s.normal, camera.up.xyz) * pixels.y, width);
    vec3 ray = (s.position - camera.origin.xyz) * (depth / camera.origin.w); // forward + aside
    float steep = dot(s.normal, orthographic ? camera.forward.xyz : ray);
    steep = steep < 0.0 ? min(steep, -1e-6) : max(steep, 1e-6);
    return along / steep * (orthographic ? 1.0 / camera.forward.w : depth);
}

uint best_pick(ivec2 pixel, vec3 position) {
    ivec2 last = textureSize(depths, 0).xy - 1;
    uint best = PICK_NOTHING;
    float least = 1e30;
    for (uint pick = 0u; pick < 9u; pick++) {
        ivec2 neighbour = clamp(pixel + pick_offset(pick), ivec2(0), last);
        surface s = surface_fetch(camera, depths, normals, ivec3(neighbour, 0));
        float off = abs(dot(s.normal, position - s.position)) +
                    APART_WEIGHT * distance(position, s.position);
        if (s.present && off < least) {
            least = off;
            best = pick;
        }
    }
    return best;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float center_depth = texelFetch(depths, ivec3(pixel, 0), 0).r;
    surface center = surface_fetch(camera, depths, normals, ivec3(pixel, 0));
    vec3 change = depth_change(center, center_depth);
    float tolerance = center.present ? PLANE_TOLERANCE * abs(change.z) : 0.0;
    if (!center.present)
        change = vec3(0.0);
    int count = int(params.samples), last = 0;
    // The samples that are not on the pixel's own plane: most pixels have none, and a loop that no
    // pixel enters is left where a branch would cost.
    for (int i = 0; i < count; i++) {
        float own_depth = center_depth + dot(change.xy, params.places[i].xy);
        if (abs(sample_depth(pixel, i) - own_depth) > tolerance)
            last = i + 1;
    }
    picks = uvec2(0u);
    for (int i = 0; i < last; i++) {
        float depth = sample_depth(pixel, i);
        vec2 size = vec2(textureSize(depths, 0).xy);
        vec2 ndc = (vec2(pixel) + 0.5 + params.places[i].xy) / size * 2.0 - 1.0;
        uint pick = depth > 0.0 ? best_pick(pixel, view_position(camera, ndc, depth)) : PICK_NOTHING;
        picks[i / 8] |= pick << uint(4 * (i % 8));
    }
}
