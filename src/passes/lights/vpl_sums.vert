// Each VPL adds up how far it is from others, and its light, and all land on one pixel. PARTNERS: how many others, which lie as
// all do: Halton's first points.
#include "lib/vpl_input.glsl"

layout(std140, binding = BLOCK_VPLS) uniform vpl_uniforms {
    vec4 vpl_rows[VPLS_PER_BLOCK * VPL_ROWS];
};

flat out vec4 value; // sum of the logarithms of their distances, and how many; red and green light

void main() {
    vpl v = vpl_input();
    vec2 pairs = vec2(0.0);
    for (int i = 0; i < PARTNERS; i++) {
        int row = i * VPL_ROWS;
        vpl other = vpl_of_rows(vpl_rows[row], vpl_rows[row + 1], vpl_rows[row + 2], vpl_rows[row + 3]);
        vec3 apart = other.position - v.position;
        // None is nearer, nor the VPL to itself, than the patch that it stands for is wide.
        float distance2 = dot(apart, apart) + v.area;
        pairs += other.reach > 0.0 ? vec2(0.5 * log2(distance2), 1.0) : vec2(0.0);
    }
    value = vec4(pairs, v.flux.rg);
    gl_Position = v.reach > 0.0 ? vec4(0.0, 0.0, 0.0, 1.0) : vec4(0.0, 0.0, 2.0, 1.0);
}
