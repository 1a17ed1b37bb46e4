// Each VPL lands on its light's pixel with its second moments about the light's centre, weighted by its flux. It
// stands for a own, not for a point: those of a square of its area are among them.
#include "lib/vpl_input.glsl"
#include "shared/bindings.h"

layout(binding = UNIT_VAL_POSITION) uniform sampler2D light_positions;

flat out vec4 value;        // xx, yy, zz; area
flat out vec4 second_value; // yz, zx, xy; squared reach of near fields

const float OF_SQUARE = 1.0 / 12.0;

void main() {
    vpl v = vpl_input();
    float weight = dot(v.flux, vec3(1.0)), own = v.area * OF_SQUARE;
    vec3 apart = v.position - texelFetch(light_positions, ivec2(int(v.val), 0), 0).xyz, n = v.normal;
    value = vec4(weight * (apart * apart + own * (1.0 - n * n)), v.area);
    second_value = vec4(weight * (apart.yzx * apart.zxy - own * n.yzx * n.zxy), weight * v.reach * v.reach * v.area);
    float count = float(textureSize(light_positions, 0).x);
    float x = (v.val + 0.5) / count * 2.0 - 1.0;
    gl_Position = v.reach > 0.0 ? vec4(x, 0.0, 0.0, 1.0) : vec4(0.0, 0.0, 2.0, 1.0);
}
