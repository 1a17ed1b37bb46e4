// What lies behind a surface is drawn faint.
layout(binding = UNIT_GBUFFER_DEPTH) uniform sampler2DArray depths;

float mark_presence(vec2 pixel, float reversed_depth) {
    float depth = texelFetch(depths, ivec3(pixel, 0), 0).r;
    float mark = view_linear_depth(camera, reversed_depth);
    bool hidden = depth > 0.0 && mark > 1.02 * view_linear_depth(camera, depth);
    return hidden ? 0.12 : 1.0;
}
