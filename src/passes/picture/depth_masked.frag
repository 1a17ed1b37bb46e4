// Depth of surfaces with holes.
#include "passes/picture/base_color.glsl"

void main() {
    if (base_color().a < material.alpha_cutoff)
        discard;
}
