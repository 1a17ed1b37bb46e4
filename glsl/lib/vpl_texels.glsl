// All VPLs, to be read by number.
#include "lib/vpl_rows.glsl"

layout(binding = UNIT_VPLS) uniform samplerBuffer vpl_texels; // the rows

vpl vpl_at(int i) {
    int row = i * VPL_ROWS;
    return vpl_of_rows(texelFetch(vpl_texels, row), texelFetch(vpl_texels, row + 1),
                       texelFetch(vpl_texels, row + 2), texelFetch(vpl_texels, row + 3));
}
