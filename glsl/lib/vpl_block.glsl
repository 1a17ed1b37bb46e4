// VPLs of a uniform block, by their numbers in it.
#include "lib/vpl_rows.glsl"

layout(std140, binding = BLOCK_VPLS) uniform vpl_uniforms {
    vec4 vpl_rows[VPLS_PER_BLOCK * VPL_ROWS];
};

vpl vpl_in_block(int i) {
    int row = i * VPL_ROWS;
    return vpl_of_rows(vpl_rows[row], vpl_rows[row + 1], vpl_rows[row + 2], vpl_rows[row + 3]);
}
