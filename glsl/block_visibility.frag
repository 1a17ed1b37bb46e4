// The visibility of map `instance` at the centre of each block.
#include "lib/surface.glsl"
#include "shared/params.h"

layout(std140, binding = BLOCK_VIEW) uniform view_uniforms {
    view camera;
};
layout(std140, binding = BLOCK_PASS) uniform pass_uniforms {
    block_params params;
};
layout(binding = UNIT_GBUFFER_DEPTH) uniform sampler2DArray depths;
layout(binding = UNIT_GBUFFER_NORMAL) uniform sampler2DArray normals;

flat in int instance;

layout(location = TARGET_RESULT) out float lit;

#include "lib/visibility.glsl"

void main() {
    int size = int(params.block);
    ivec2 pixel = min(ivec2(gl_FragCoord.xy) * size + size / 2, textureSize(depths, 0).xy - 1);
    surface s = surface_fetch(camera, depths, normals, ivec3(pixel, 0));
    lit = s.present ? visibility(instance, s.position, s.normal) : 1.0;
}
