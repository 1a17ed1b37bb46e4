// Irradiance at points of surfaces from a run of VPLs:
//     E = sum_i Phi_i / pi  cos_i cos (d^2 + A / pi) / (d^4 + (A / pi)^2)  V_C(i)
// Both ends stand for patches, and A is the larger one's: a large patch beside a small VPL would take more than that
// sends.
// A column is a point. Each row takes a part of the VPLs; or, with CANDIDATES, is another candidate, which takes all.
#include "lib/vpl_block.glsl"
#include "lib/vpl_texels.glsl" // the points: flux is their albedo
#include "visibility/visibility.glsl"
#include "gather/patch.glsl"
#include "shared/bounce.h"

// First VPL and count within the block.
layout(location = LOCATION_SLOT) uniform ivec4 run;
// Which map the block's first VPL has, where each VPL has its own.
layout(location = LOCATION_FIRST_MAP) uniform int first_map;

#if CANDIDATES
layout(location = TARGET_RESULT) out vec4 irradiance;
#else
layout(location = TARGET_BOUNCE_LAST) out vec4 irradiance;
layout(location = TARGET_BOUNCE_SUM) out vec4 irradiance_of_all;
#endif

const float INVERSE_PI = 0.31830988618;

float geometry_term(vpl light, vpl point) {
    vec3 to_light = light.position - point.position;
    float distance2 = dot(to_light, to_light);
    float cosines = max(dot(point.normal, to_light), 0.0) * max(-dot(light.normal, to_light), 0.0);
    return cosines > 0.0 ? patch_term(cosines, distance2, max(light.area, point.area)) : 0.0;
}

int map_of(int i, vpl light) {
#if MAP_PER_VPL
    return first_map + i;
#else
    return int(light.val);
#endif
}

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
#if CANDIDATES
    vpl point = vpl_at(texel.x * BOUNCE_CANDIDATES + texel.y);
    int first = run.x, last = run.x + run.y;
#else
    vpl point = vpl_at(texel.x);
    int first = run.x + run.y * texel.y / BOUNCE_ROWS, last = run.x + run.y * (texel.y + 1) / BOUNCE_ROWS;
#endif
    vec3 sum = vec3(0.0);
    for (int i = first; i < last; i++) {
        vpl light = vpl_in_block(i);
        vec3 arriving = light.flux * geometry_term(light, point);
        float visible = 1.0;
        if (arriving != vec3(0.0))
            visible = visibility_from(map_of(i, light), point.position, point.normal, light.position);
        sum += arriving * visible;
    }
    irradiance = vec4(sum * INVERSE_PI, 0.0);
#if !CANDIDATES
    irradiance_of_all = irradiance;
#endif
}
