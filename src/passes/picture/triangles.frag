// Writes the number of the triangle that the pixel's centre shows, from 1 on. Holes of alpha masks and backs of
// single-sided surfaces are not there, as in passes/picture/geometry.frag.
#include "passes/picture/base_color.glsl"

layout(location = LOCATION_FIRST_TRIANGLE) uniform int first_triangle; // of the draw

layout(location = TARGET_RESULT) out uint triangle;

void main() {
    bool kept = base_color().a >= material.alpha_cutoff && (gl_FrontFacing || material.double_sided);
    triangle = uint(first_triangle + gl_PrimitiveID + 1);
    if (!kept)
        discard;
}
