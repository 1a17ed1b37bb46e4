// A VPL as a disc.
#include "lib/mark.glsl"

layout(location = ATTRIBUTE_VPL_POSITION) in vec4 position; // w: C(i)
layout(location = ATTRIBUTE_VPL_NORMAL) in vec4 normal;
layout(location = ATTRIBUTE_VPL_FLUX) in vec4 flux;

flat out vec3 mark_color;
flat out float strength;
flat out vec2 middle;

void main() {
    gl_Position = camera.world_to_clip * vec4(position.xyz, 1.0);
    gl_PointSize = params.size;
    vec3 glow = flux.rgb * params.flux_scale;
    mark_color = params.by_cluster > 0.5 ? cluster_color(int(position.w)) : pow(glow / (1.0 + glow), vec3(0.4545));
    strength = params.by_cluster > 0.5 ? cluster_strength(int(position.w)) : 1.0;
    middle = (gl_Position.xy / gl_Position.w * 0.5 + 0.5) * vec2(params.width, params.height);
    if (flux.w <= 0.0)
        gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
}
