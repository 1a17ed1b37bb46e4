// Depth alone. MASKED: of surfaces with holes.
#ifdef MASKED
#include "passes/picture/base_color.glsl"
#endif

void main() {
#ifdef MASKED
    if (base_color().a < material.alpha_cutoff)
        discard;
#endif
}
