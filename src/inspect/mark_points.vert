// A VPL as a disc.
#include "inspect/mark.glsl"
#include "lib/vpl_input.glsl"

flat out vec3 mark_color;
flat out float strength;
flat out vec2 middle;

void main() {
    vpl v = vpl_input();
    gl_Position = camera.world_to_clip * vec4(v.position, 1.0);
    gl_PointSize = params.size;
    vec3 glow = v.flux * params.flux_scale;
    mark_color = params.by_cluster ? cluster_color(int(v.val)) : pow(glow / (1.0 + glow), vec3(0.4545));
    strength = params.by_cluster ? cluster_strength(int(v.val)) : 1.0;
    middle = (gl_Position.xy / gl_Position.w * 0.5 + 0.5) * params.picture;
    if (v.reach <= 0.0)
        gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
}
