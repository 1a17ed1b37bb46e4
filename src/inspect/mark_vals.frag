#include "inspect/mark.glsl"
#include "inspect/mark_depth.glsl"

flat in vec3 mark_color;
flat in float strength;
noperspective in float across;

layout(location = TARGET_RESULT) out vec4 color;

void main() {
    float inside = clamp(0.5 * params.size + 0.5 - abs(across), 0.0, 1.0);
    float alpha = inside * strength * max(mark_presence(gl_FragCoord.xy, gl_FragCoord.z), 0.3);
    color = vec4(mark_color, 1.0) * alpha;
}
