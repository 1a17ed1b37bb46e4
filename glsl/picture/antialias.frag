// Gives each sample of the pixel to the neighbour whose surface it lies on [Chajdas et al. 2011 §3], and finds a
// further point to shade where it lies on none's.
#include "lib/further_point.glsl"
#include "picture/picks.glsl"
#include "picture/sample_plane.glsl"

layout(binding = UNIT_SAMPLE_NORMAL) uniform sampler2DMSArray sample_normals;

// Before the shader, or it would run everywhere.
layout(early_fragment_tests) in;
layout(rgba32ui, binding = IMAGE_FURTHER_POINTS) writeonly uniform uimage2D further_points;

layout(location = TARGET_RESULT) out uvec2 picks;

// A neighbour far off in depth along its own plane is less likely than a near one: a silhouette's plane
// holds the line of sight, and with it whatever lies behind.
const float APART_WEIGHT = 0.1;
// The same of normals: a thin thing's rim is as near to its face as to itself.
const float UNLIKE_WEIGHT = 1.0;
// From here on no neighbour's surface is the sample's.
const float UNLIKELY = 0.3;

vec3 sample_normal(ivec2 pixel, int i) {
    ivec3 texel = ivec3(pixel, i / SAMPLES_PER_LAYER);
    return octahedral_decode(texelFetch(sample_normals, texel, i % SAMPLES_PER_LAYER).rg);
}

// How far two depths lie from each other, over the pixel's width there.
float apart(float a, float b) {
    float width = 2.0 * length(camera.right) / float(gbuffer_size().x);
    return (camera.orthographic ? abs(a - b) * camera.far : abs(a / max(b, 1e-30) - 1.0)) / width;
}

// How unlikely it is that a sample lies on the plane.
float unlikelihood(plane p, vec2 place, float depth, vec3 normal) {
    return off_plane(p, place, depth) / p.across + APART_WEIGHT * apart(p.depth, depth) +
           UNLIKE_WEIGHT * (1.0 - dot(p.normal, normal));
}

// The pixel's samples, and for each the neighbour that it most likely lies on.
float depth[SAMPLES], least[SAMPLES];
vec3 normal[SAMPLES];
uint best[SAMPLES];

void read_samples(ivec2 pixel) {
    for (int i = 0; i < SAMPLES; i++) {
        depth[i] = sample_depth(pixel, i);
        normal[i] = sample_normal(pixel, i);
        least[i] = 1e30;
        best[i] = PICK_NOTHING;
    }
}

// Of the neighbours, the pixel itself first.
void try_neighbour(ivec2 pixel, uint pick) {
    ivec2 offset = clamp(pixel + pick_offset(pick), ivec2(0), gbuffer_size() - 1) - pixel;
    plane p = plane_of(pixel + offset);
    for (int i = 0; i < SAMPLES; i++) {
        float unlikely = unlikelihood(p, params.places[i].xy - vec2(offset), depth[i], normal[i]);
        bool better = p.depth > 0.0 && depth[i] > 0.0 && unlikely < least[i];
        least[i] = better ? unlikely : least[i];
        best[i] = better ? pick : best[i];
    }
}

// One of the samples, in values of its own: an array that is read at a place that is not known beforehand lies in
// memory, all of it.
struct picked_sample {
    vec2 place;
    float depth;
    vec3 normal;
    uint pick;
};

// The one that lies off all neighbours' surfaces most; false where none does.
bool most_unlikely(out picked_sample found) {
    float most = UNLIKELY;
    found = picked_sample(vec2(0.0), 0.0, vec3(0.0), PICK_NOTHING);
    for (int i = 0; i < SAMPLES; i++) {
        bool more = best[i] != PICK_NOTHING && least[i] > most;
        most = more ? least[i] : most;
        found.place = more ? params.places[i].xy : found.place;
        found.depth = more ? depth[i] : found.depth;
        found.normal = more ? normal[i] : found.normal;
        found.pick = more ? best[i] : found.pick;
    }
    return most > UNLIKELY;
}

// That sample is the further point, and others that rather lie on its surface are lit as it.
void take_further_point(ivec2 pixel, picked_sample chosen) {
    further_point point = further_point(chosen.depth, chosen.normal, chosen.place, chosen.pick);
    imageStore(further_points, pixel, further_point_pack(point));
    plane p = plane_at(vec2(pixel) + 0.5 + chosen.place, chosen.depth, chosen.normal);
    for (int i = 0; i < SAMPLES; i++) {
        float unlikely = unlikelihood(p, params.places[i].xy - chosen.place, depth[i], normal[i]);
        best[i] = depth[i] > 0.0 && unlikely < least[i] ? PICK_FURTHER : best[i];
    }
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    read_samples(pixel);
    for (uint pick = 0u; pick < 9u; pick++)
        try_neighbour(pixel, pick);
    picked_sample chosen;
    if (most_unlikely(chosen))
        take_further_point(pixel, chosen);
    picks = uvec2(0u);
    for (int i = 0; i < SAMPLES; i++)
        picks[i / 8] |= best[i] << uint(4 * (i % 8));
}
