// Irradiance of the elements around each pixel's surface that face as it does.
#include "lib/gbuffer.glsl"
#include "shared/element_grid.h"

layout(binding = UNIT_ELEMENT_CELLS) uniform usamplerBuffer element_cells;
layout(binding = UNIT_ELEMENTS) uniform samplerBuffer elements;

layout(location = TARGET_RESULT) out vec4 result;

// An element this far off the surface's plane does not count, over the reach.
const float OFF_PLANE = 0.4;
// Of elements that do not count else: where there are no others.
const float LAST_RESORT = 1e-6;

void add_element(surface s, int number, inout vec4 sum) {
    vec4 place = texelFetch(elements, ELEMENT_TEXELS * number);
    vec3 path = (place.xyz - s.position) / params.cell;
    float distance2 = dot(path, path);
    float facing = dot(texelFetch(elements, ELEMENT_TEXELS * number + 1).xyz, s.normal);
    if (distance2 >= 3.0 || facing <= 0.0)
        return;
    float falloff = max(1.0 - distance2, 0.0), plane = max(1.0 - abs(dot(path, s.normal)) / OFF_PLANE, 0.0);
    float weight = facing * facing * (falloff * falloff * plane * place.w + LAST_RESORT / (1e-3 + distance2));
    sum += weight * vec4(texelFetch(elements, ELEMENT_TEXELS * number + 2).xyz, 1.0);
}

void main() {
    result = vec4(0.0);
    surface s = gbuffer_surface(ivec2(gl_FragCoord.xy));
    if (!s.present)
        return;
    ivec3 counts = ivec3(params.cells_x, params.cells_y, params.cells_z);
    ivec3 middle = clamp(ivec3((s.position - params.low) / params.cell), ivec3(1), counts - 2);
    vec4 sum = vec4(0.0);
    for (int k = 0; k < 9; k++) {
        ivec2 row = middle.yz + ivec2(k % 3 - 1, k / 3 - 1);
        int cell = (row.y * counts.y + row.x) * counts.x + middle.x - 1;
        int end = int(texelFetch(element_cells, cell + 3).r);
        for (int number = int(texelFetch(element_cells, cell).r); number < end; number++)
            add_element(s, number, sum);
    }
    result = vec4(sum.w > 0.0 ? sum.rgb / sum.w * params.scale : vec3(0.0), 1.0);
}
