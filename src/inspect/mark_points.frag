#include "inspect/mark.glsl"
#include "inspect/mark_depth.glsl"

flat in vec3 mark_color;
flat in float strength;
flat in vec2 middle;

layout(location = TARGET_RESULT) out vec4 color;

void main() {
    float radius = 0.5 * params.size, away = distance(gl_FragCoord.xy, middle);
    float inside = clamp(radius - away, 0.0, 1.0), core = clamp(radius - 1.0 - away, 0.0, 1.0);
    float alpha = inside * strength * mark_presence(middle, gl_FragCoord.z);
    color = vec4(mark_color * core, 1.0) * alpha;
}
