// The density of VPLs in a cell: of its light, times four times the fraction of each node that it lies in.
#include "passes/lights/importance_parts.glsl"

layout(binding = UNIT_IMPORTANCE_LIGHTS) uniform sampler2D importance_lights;

layout(location = TARGET_RESULT) out float density;

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy), tile = texel / VPL_DENSITY_SIDE;
    ivec2 cell = texel - tile * VPL_DENSITY_SIDE;
    int index = tile.y * VPL_DENSITY_ROW + tile.x;
    density = 0.0;
    if (index >= textureSize(importance_lights, 0).x)
        return;
    density = texelFetch(importance_lights, ivec2(index, 0), 0).r;
    for (int level = VPL_DENSITY_LEVELS - 2; level >= 0; level--) {
        ivec2 at = cell >> level;
        vec4 parts = importance_parts(index, at & ~1, level);
        density *= 4.0 * parts[(at.x & 1) + 2 * (at.y & 1)] / dot(parts, vec4(1.0));
    }
}
