// A ray from a light through smooth surfaces, up to a surface that scatters (chapter 8 of [Dong 2011]). The thesis takes
// depth maps for surfaces, two of them at most. Here rays meet triangles, any number of them.
#include "lib/light.glsl"
#include "lib/medium.glsl"
#include "lib/random.glsl"
#include "shared/caustics.h"
#include "passes/visibility/bvh.glsl"
#include "passes/caustics/chain.glsl"

// Where the ray of a texel begins: texels of a light's view have equal solid angles, or areas.
struct light_ray {
    vec3 origin, direction;
    vec3 flux; // W
};

// Of a place from 0 to 1; beyond the cap or disk there is no light. Lambert's azimuthal projection keeps areas.
light_ray light_ray_at(light l, vec2 place) {
    vec2 disk = 2.0 * place - 1.0;
    float measure = dot(disk, disk) <= 1.0 ? params.measure : 0.0;
    vec3 aside = disk.x * params.right + disk.y * params.up;
    if (params.is_disk)
        return light_ray(params.start + params.spread * aside, params.axis, l.intensity * measure);
    float below = dot(disk, disk) * params.spread; // one less the cosine
    vec3 across = sqrt(params.spread * max(2.0 - below, 0.0)) * aside;
    vec3 direction = normalize((1.0 - below) * params.axis + across);
    return light_ray(l.position, direction, light_intensity(l, direction) * measure);
}

#ifdef HAS_LINES
// Light between two smooth surfaces outside glass. A ray keeps one of these segments, chosen by chance in proportion to
// its light times its length, and it stands for all of them (reservoir sampling).
vec3 between_from = vec3(0.0), between_to = vec3(0.0);
vec3 between_flux = vec3(0.0); // over the segment's weight
float between_weights = 0.0;   // of all segments

void between_add(walk w, float metres, float number) {
    float weight = dot(w.flux, vec3(1.0)) * max(metres, 0.0);
    between_weights += weight;
    if (number * between_weights < weight) {
        between_from = w.place;
        between_to = w.origin + metres * w.direction;
        between_flux = w.flux / weight;
    }
}

// Red and green, over the sum of three channels, as one whole number. Chance rounds, so that each channel is right on
// average, however small its share.
void between_pack(float number, out vec4 leave, out vec4 end) {
    float red_green = between_flux.r + between_flux.g, sum = red_green + between_flux.b;
    vec2 shares = sum > 0.0 ? vec2(between_flux.r, red_green) / sum : vec2(0.0);
    vec2 levels = min(floor(shares * BETWEEN_LEVELS + number), BETWEEN_LEVELS);
    leave = vec4(between_from, sum * between_weights);
    end = vec4(between_to, levels.x * (BETWEEN_LEVELS + 1.0) + levels.y - levels.x);
}
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
