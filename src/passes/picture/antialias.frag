// Gives each sample of the pixel to the neighbour whose surface it lies on [Chajdas et al. 2011 §3], and finds an
// edge sample to shade where it lies on none's.
#include "lib/edge_sample.glsl"
#include "passes/picture/sample_plane.glsl"

layout(binding = UNIT_SAMPLE_NORMAL) uniform sampler2DMSArray sample_normals;

// Before the shader, or it would run everywhere.
layout(early_fragment_tests) in;
layout(rgba32ui, binding = IMAGE_EDGE_SAMPLES) writeonly uniform uimage2D edge_samples;

layout(location = TARGET_RESULT) out uvec2 assignment;

// A neighbour far off in depth along its own plane is less likely than a near one: a silhouette's plane
// holds the line of sight, and with it whatever lies behind.
const float APART_WEIGHT = 0.1;
// The same of normals: a thin thing's rim is as near to its face as to itself.
const float UNLIKE_WEIGHT = 1.0;
// From here on no neighbour's surface is the sample's.
const float UNLIKELY = 0.3;

vec3 sample_normal(ivec2 pixel, int i) {
    ivec3 texel = ivec3(pixel, i / SAMPLES_PER_LAYER);
    return normalize(texelFetch(sample_normals, texel, i % SAMPLES_PER_LAYER).rgb - 0.5);
}

// The pixel's samples, and for each the neighbour that it most likely lies on.
float depth[SAMPLES], least[SAMPLES];
float apart[SAMPLES]; // what a depth off theirs counts for
vec3 normal[SAMPLES];
uint best[SAMPLES];

// None lies on anything where a sample sees nothing.
void read_samples(ivec2 pixel) {
    float width = 2.0 * length(camera.right) / float(gbuffer_size().x);
    for (int i = 0; i < SAMPLES; i++) {
        depth[i] = sample_depth(pixel, i);
        normal[i] = sample_normal(pixel, i);
        apart[i] = APART_WEIGHT / width * (camera.orthographic ? camera.far : 1.0 / max(depth[i], 1e-30));
        least[i] = depth[i] > 0.0 ? 1e30 : -1.0;
        best[i] = ASSIGNED_NOTHING;
    }
}

// A surface that samples may lie on: its plane in widths of a pixel off it, by places from the pixel's centre.
struct candidate {
    vec2 slope;
    float off, scale;
    float depth;
    vec3 normal;
};

// At a place, pixels from the pixel's centre.
candidate candidate_of(plane p, vec2 place) {
    if (p.depth <= 0.0)
        return candidate(vec2(0.0), 2e30, 0.0, 0.0, p.normal); // no surface: worse than none tried
    vec2 slope = p.slope / p.across;
    return candidate(slope, p.depth / p.across - dot(slope, place), 1.0 / p.across, p.depth, p.normal);
}

// How unlikely it is that a sample lies there.
float unlikelihood(candidate c, int i) {
    float off = abs(c.off + dot(c.slope, params.places[i].xy) - c.scale * depth[i]);
    return off + apart[i] * abs(c.depth - depth[i]) + UNLIKE_WEIGHT * (1.0 - dot(c.normal, normal[i]));
}

// The samples that rather lie there than on what was tried before.
void try_candidate(candidate c, uint assigned) {
    for (int i = 0; i < SAMPLES; i++) {
        float unlikely = unlikelihood(c, i);
        bool better = unlikely < least[i];
        least[i] = better ? unlikely : least[i];
        best[i] = better ? assigned : best[i];
    }
}

// Of the neighbours, the pixel itself first.
void try_neighbour(ivec2 pixel, uint assigned) {
    ivec2 offset = clamp(pixel + assigned_offset(assigned), ivec2(0), gbuffer_size() - 1) - pixel;
    try_candidate(candidate_of(plane_of(pixel + offset), vec2(offset)), assigned);
}

// One of the samples, in values of its own: an array that is read at a place that is not known beforehand lies in
// memory, all of it.
struct unlikely_sample {
    vec2 place;
    float depth;
    vec3 normal;
    uint assigned;
};

// The one that lies off all neighbours' surfaces most; false where none does.
bool most_unlikely(out unlikely_sample found) {
    float most = UNLIKELY;
    found = unlikely_sample(vec2(0.0), 0.0, vec3(0.0), ASSIGNED_NOTHING);
    for (int i = 0; i < SAMPLES; i++) {
        bool more = best[i] != ASSIGNED_NOTHING && least[i] > most;
        most = more ? least[i] : most;
        found.place = more ? params.places[i].xy : found.place;
        found.depth = more ? depth[i] : found.depth;
        found.normal = more ? normal[i] : found.normal;
        found.assigned = more ? best[i] : found.assigned;
    }
    return most > UNLIKELY;
}

// That sample is the edge sample, and others that rather lie on its surface are lit as it.
void take_edge_sample(ivec2 pixel, unlikely_sample chosen) {
    edge_sample point = edge_sample(chosen.depth, chosen.normal, chosen.place, chosen.assigned);
    imageStore(edge_samples, pixel, edge_sample_pack(point));
    plane p = plane_at(vec2(pixel) + 0.5 + chosen.place, chosen.depth, chosen.normal);
    try_candidate(candidate_of(p, chosen.place), ASSIGNED_EDGE_SAMPLE);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    read_samples(pixel);
    for (uint assigned = 0u; assigned < 9u; assigned++)
        try_neighbour(pixel, assigned);
    unlikely_sample chosen;
    if (most_unlikely(chosen))
        take_edge_sample(pixel, chosen);
    assignment = uvec2(0u);
    for (int i = 0; i < SAMPLES; i++)
        assignment[i / 8] |= best[i] << uint(4 * (i % 8));
}
