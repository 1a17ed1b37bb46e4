// A mark: a round point or, with LINES, a line. What lies behind a surface is drawn faint.
#include "inspect/mark.glsl"

flat in vec3 mark_color;
flat in float strength;
#ifdef LINES
noperspective in float across;
#else
flat in vec2 middle;
#endif

layout(location = TARGET_RESULT) out vec4 color;

float mark_presence(vec2 pixel, float reversed_depth) {
    float depth = gbuffer_depth(ivec2(pixel));
    float mark = view_linear_depth(camera, reversed_depth);
    bool hidden = depth > 0.0 && mark > 1.02 * view_linear_depth(camera, depth);
    return hidden ? 0.12 : 1.0;
}

void main() {
#ifdef LINES
    float inside = clamp(0.5 * params.size + 0.5 - abs(across), 0.0, 1.0), core = 1.0;
    float alpha = inside * strength * max(mark_presence(gl_FragCoord.xy, gl_FragCoord.z), 0.3);
#else
    float radius = 0.5 * params.size, away = distance(gl_FragCoord.xy, middle);
    float inside = clamp(radius - away, 0.0, 1.0), core = clamp(radius - 1.0 - away, 0.0, 1.0);
    float alpha = inside * strength * mark_presence(middle, gl_FragCoord.z);
#endif
    color = vec4(mark_color * core, 1.0) * alpha;
}
