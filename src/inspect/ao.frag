// Ambient occlusion as a layer of a file: the mean over the samples of a pixel that show a surface. A sample takes the
// value of the pixel that it is assigned to, as light does; edge samples take that of their stand-in.
#include "lib/gbuffer.glsl"
#include "lib/edge_sample.glsl"

layout(binding = UNIT_IRRADIANCE) uniform sampler2D open; // alpha 0: not known
layout(binding = UNIT_SAMPLE_ASSIGNMENT) uniform usampler2D sample_assignment;
layout(binding = UNIT_EDGE_SAMPLES) uniform usampler2D edge_samples;

layout(location = TARGET_RESULT) out vec4 value;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy), last = gbuffer_size() - 1;
    uvec2 assignment = texelFetch(sample_assignment, min(pixel, textureSize(sample_assignment, 0) - 1), 0).rg;
    uint stand_in = has_edge_sample(assignment) ? texelFetch(edge_samples, pixel, 0).w : 0u;
    int count = assignment == uvec2(0u) ? 1 : SAMPLES;
    vec2 sum = vec2(0.0);
    for (int i = 0; i < count; i++) {
        uint assigned = assigned_to(assignment, i);
        if (assigned == ASSIGNED_NOTHING)
            continue;
        uint from = assigned == ASSIGNED_EDGE_SAMPLE ? stand_in : assigned;
        vec4 seen = texelFetch(open, clamp(pixel + assigned_offset(from), ivec2(0), last), 0);
        sum += vec2(seen.r, 1.0) * seen.a;
    }
    value = vec4(sum.x / max(sum.y, 1.0));
}
