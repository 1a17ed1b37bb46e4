// The normals of a pixel's samples, beside their depths: of surfaces that nothing of is discarded.
#include "lib/octahedral.glsl"
#include "shared/types.h"

centroid in vec3 surface_normal;

layout(location = TARGET_GBUFFER_NORMAL) out vec2 normal_code;

void main() {
    normal_code = octahedral_encode(gl_FrontFacing ? surface_normal : -surface_normal);
}
