// A ray from a light through smooth surfaces, up to a surface that scatters (chapter 8 of [Dong 2011]). The thesis takes
// depth maps for surfaces, two of them at most. Here rays meet triangles, any number of them.
#include "lib/light.glsl"
#include "lib/medium.glsl"
#include "lib/random.glsl"
#include "shared/caustics.h"
#include "visibility/bvh.glsl"
#include "caustics/chain.glsl"
#include "caustics/ray_start.glsl"
#ifdef HAS_LINES
#include "caustics/range.glsl"
#include "caustics/between.glsl"
#endif

layout(location = LOCATION_LIGHT) uniform int light_index;

layout(location = TARGET_RAY_LEAVE) out vec4 ray_leave;
layout(location = TARGET_RAY_END) out vec4 ray_end;
layout(location = TARGET_RAY_FLUX) out vec4 ray_flux;
#ifdef HAS_LINES
layout(location = TARGET_BETWEEN_LEAVE) out vec4 between_leave;
layout(location = TARGET_BETWEEN_END) out vec4 between_end;
#endif

// Others in each pass.
vec2 numbers_of(ivec2 texel, int event) {
    return random_of(uvec3(texel, uint(event) ^ floatBitsToUint(params.shift.x)));
}

float ends_at(vec3 place, vec3 direction) {
#ifdef HAS_MEDIUM
    return medium_segment(place, direction, params.far).y;
#else
    return params.far;
#endif
}

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    light l = light_at(light_index);
    int chain = texel.y / params.side;
    texel.y -= chain * params.side;
    light_ray ray = light_ray_at(l, (vec2(texel) + 0.5 + params.shift) / float(params.side));
    float way = params.is_disk ? 0.0 : bvh_clearance(); // off the lamp's own surface
    walk w = walk_from(ray.origin + way * ray.direction, ray.direction, ray.flux, chain, params.chains);
    bool goes = dot(w.flux, vec3(1.0)) > 0.0;
    ray_leave = ray_end = ray_flux = vec4(0.0);
#ifdef HAS_LINES
    vec2 chance = numbers_of(ivec2(gl_FragCoord.xy), BETWEEN_NUMBERS);
    float comes = comes_by_chance(l, chance.y);
#endif
    for (int event = 0; event <= CHAIN_EVENTS && goes; event++) {
        bvh_hit hit = bvh_meet(w.origin, w.direction, goes);
        int row = smooth_row(hit.triangle);
        if (row == 0) {
            bool lands = hit.triangle >= 0;
            float far = lands ? hit.distance : max(ends_at(w.origin, w.direction), 0.0);
            goes = false;
            if (event > 0 && w.inner <= 0 && l.range_inverse2 * way * way < 1.0) {
                ray_leave = vec4(w.place, uintBitsToFloat(packSnorm4x8(vec4(hit.normal, 0.5))));
                ray_end = vec4(w.origin + far * w.direction, lands ? RAY_LANDS : RAY_ESCAPES);
                ray_flux = vec4(w.flux, way);
            }
        } else {
            smooth_material m = smooth_material_at(row);
            vec2 numbers = numbers_of(ivec2(gl_FragCoord.xy), event);
#ifdef HAS_LINES
            if (event > 0 && w.inner <= 0 && !is_within(hit, m))
                between_add(w, min(hit.distance, comes - way), numbers.y);
#endif
            w.flux *= is_within(hit, m) ? exp(-m.absorption * hit.distance)
                                        : medium_passes_along(w.origin, w.direction, hit.distance);
            walk_goes_on(w, hit, m, event == 0, numbers.x);
            way += hit.distance;
            goes = dot(w.flux, vec3(1.0)) > 0.0;
        }
    }
#ifdef HAS_LINES
    between_pack(chance.x, between_leave, between_end);
#endif
}
