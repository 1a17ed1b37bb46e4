// For test_lookup.c: what the projection says of each point, and the filter's answer.
#include "passes/visibility/lookup.glsl"
#if PROJECTION == PROJECTION_PARABOLOID
#include "passes/visibility/projection_paraboloid.glsl"
#elif PROJECTION == PROJECTION_ORTHOGRAPHIC
#include "passes/visibility/projection_orthographic.glsl"
#else
#include "passes/visibility/projection_perspective.glsl"
#endif
#if FILTER == FILTER_PCF
#include "passes/visibility/filter_pcf.glsl"
#else
#include "passes/visibility/filter_val.glsl"
#endif

layout(local_size_x = 64) in;

#if PROJECTION == PROJECTION_PARABOLOID
#define VIEW map_view
#else
#define VIEW view
#endif

layout(std140, binding = BLOCK_PASS) uniform tested_uniforms {
    VIEW tested;
    vec4 extent; // x counts
};

struct point {
    vec4 position, normal;
};
layout(std430, binding = 0) readonly buffer point_storage {
    point points[];
};

struct answer {
    vec2 uv;
    float seen, depth, plane, texel, light, penumbra, width, share, unused0, unused1;
};
layout(std430, binding = 1) writeonly buffer answer_storage {
    answer answers[];
};

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= uint(points.length()))
        return;
    answer a = answer(vec2(0.0), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0);
    receiver r;
    if (project(tested, points[i].position.xyz, points[i].normal.xyz, r)) {
        a.seen = 1.0;
        a.uv = r.uv;
        a.depth = r.distance / r.unit;
        // Through the next texel to the right.
        a.plane = receiver_distance(r, ivec2(r.uv * lookup.map_size) + ivec2(1, 0)) / r.unit;
        a.texel = map_depth(r, 0.25);
        a.light = light_angle(r, extent.x, r.distance);
        a.penumbra = penumbra_angle(extent.x, r.distance, 0.6 * r.distance);
        a.width = angle_width(r, 0.01);
#if FILTER != FILTER_NONE
        a.share = lit(0, r, extent.x);
#endif
    }
    answers[i] = a;
}
