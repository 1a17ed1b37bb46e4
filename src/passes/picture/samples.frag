// The normals of a pixel's samples, beside their depths, as 0.5 + 0.5 n: an octahedron's code takes time at each fragment.
// MASKED: of surfaces with holes.
#ifdef MASKED
#include "passes/picture/base_color.glsl"
#else
#include "shared/types.h"
#endif

// Not linear in the picture: where triangles that reach behind the camera are clipped, llvmpipe has it wrong, and black
// pixels lay along silhouettes.
centroid in vec3 surface_normal;

layout(location = TARGET_GBUFFER_NORMAL) out vec3 stored_normal;

void main() {
#ifdef MASKED
    float alpha = base_color().a;
    if (alpha < material.alpha_cutoff || (!gl_FrontFacing && !material.double_sided))
        discard;
#endif
    stored_normal = 0.5 + (gl_FrontFacing ? 0.5 : -0.5) * surface_normal;
}
