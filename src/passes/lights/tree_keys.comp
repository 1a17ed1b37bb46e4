// The key of a VPL: its place and normal along a Z-order curve of six dimensions, so that what is near to each
// other and looks the same way comes side by side. What met nothing, and is not there, comes last.
#include "passes/lights/tree_keys.glsl"
#include "lib/vpl_texels.glsl"

layout(local_size_x = TREE_GROUP) in;

const int DIMENSIONS = 6, BITS = 5; // of a word

// Of coordinates in [0, 1), as many words further.
uint curve(float coordinates[DIMENSIONS], int word) {
    uint key = 0u;
    for (int bit = BITS - 1; bit >= 0; bit--)
        for (int d = 0; d < DIMENSIONS; d++) {
            uint cell = uint(clamp(coordinates[d], 0.0, 0.999999) * float(1 << (BITS * (word + 1))));
            key = key << 1 | (cell >> bit & 1u);
        }
    return key;
}

uvec2 key_of(vpl light) {
    vec3 sides = params.bounds_max - params.bounds_min, normal = 0.5 + 0.5 * light.normal;
    vec3 place = (light.position - params.bounds_min) / max(max(sides.x, sides.y), sides.z);
    float coordinates[DIMENSIONS] = float[](place.x, place.y, place.z, normal.x, normal.y, normal.z);
    return uvec2(curve(coordinates, 0), curve(coordinates, 1));
}

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= params.leaves)
        return;
    uvec2 key = uvec2(0xffffffffu);
    if (i < params.vpl_count) {
        vpl light = vpl_at(i);
        if (light.reach > 0.0)
            key = key_of(light);
    }
    tree_keys[i] = uvec4(key, uint(i), 0u);
}
