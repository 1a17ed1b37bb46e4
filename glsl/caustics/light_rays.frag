// A ray from a light through smooth surfaces, up to a surface that scatters (chapter 8 of [Dong 2011]). The thesis takes
// depth maps for surfaces, two of them at most. Here rays meet triangles, any number of them.
//
// A ray that meets glass divides. Each band of texels follows one chain: 0 is reflected outside, 1 goes through, and chain
// k is reflected k - 1 times within where it could leave. Where the last one could leave, a number picks whether it does,
// and so it does for all chains at the glass after that: no light is lost, and neighbours mostly take the same way.
#include "lib/light.glsl"
#include "lib/medium.glsl"
#include "lib/random.glsl"
#include "visibility/bvh.glsl"
#include "caustics/smooth.glsl"
#include "caustics/ray_start.glsl"

layout(location = LOCATION_LIGHT) uniform int light_index;

layout(location = TARGET_RAY_LEAVE) out vec4 ray_leave;
layout(location = TARGET_RAY_END) out vec4 ray_end;
layout(location = TARGET_RAY_FLUX) out vec4 ray_flux;

struct walk {
    vec3 place, direction;
    vec3 flux;
    int chain, inner; // inner: reflections within that are left
    bool picks;
};

float fresnel(float cosine, float ratio, float refracted) {
    float along = (cosine - ratio * refracted) / (cosine + ratio * refracted);
    float across = (ratio * cosine - refracted) / (ratio * cosine + refracted);
    return 0.5 * (along * along + across * across);
}

// Through glass or back from it; the normal is of the ray's side.
void meet_glass(inout walk w, smooth_material m, vec3 normal, bool back, bool is_first, float number) {
    float cosine = clamp(-dot(w.direction, normal), 1e-6, 1.0);
    float ratio = back && !m.thin ? m.refraction : 1.0 / m.refraction; // of indices, before over behind
    float square = 1.0 - ratio * ratio * (1.0 - cosine * cosine);
    float refracted = sqrt(max(square, 0.0)), reflects = square <= 0.0 ? 1.0 : fresnel(cosine, ratio, refracted);
    if (m.thin)
        reflects = 2.0 * reflects / (1.0 + reflects); // of both sides, with all reflections between them
    bool is_within = back && !m.thin, total = square <= 0.0;
    if (is_first && is_within) { // of a light in the glass
        w.picks = true;
        w.flux *= w.chain > 0 ? 0.0 : 1.0;
    }
    bool picks = w.picks;
    bool turns = number < reflects;
    if (!picks && is_first)
        turns = w.chain == 0;
    else if (!picks && is_within && !total) {
        turns = w.inner > 0;
        picks = !turns && w.chain == params.chains - 1;
        turns = picks ? number < reflects : turns;
    } else
        picks = true;
    w.picks = w.picks || (is_first ? w.chain == 0 : is_within && !total && !turns);
    w.inner -= turns && is_within && !total && w.inner > 0 ? 1 : 0;
    if (total || turns) {
        w.direction += 2.0 * cosine * normal;
        w.flux *= picks ? 1.0 : reflects;
        return;
    }
    w.flux *= (picks ? 1.0 : 1.0 - reflects) * m.passes * m.base;
    if (!m.thin)
        w.direction = normalize(ratio * w.direction + (ratio * cosine - refracted) * normal);
}

// The second normal is the triangle's, which takes over where the first one sends light behind the triangle.
void meet_mirror(inout walk w, smooth_material m, vec3 normal, vec3 flat_normal, bool back, bool is_first) {
    vec3 turned = reflect(w.direction, normal);
    w.direction = dot(turned, flat_normal) > 0.0 ? turned : reflect(w.direction, flat_normal);
    w.flux *= (is_first && w.chain > 0) || (back && !m.two_sided) ? vec3(0.0) : m.base;
    w.picks = true;
}

vec3 passes_outside(vec3 place, vec3 direction, float metres) {
#ifdef HAS_MEDIUM
    vec2 part = medium_segment(place, direction, metres);
    return medium_passes(part.y - part.x);
#else
    return vec3(1.0);
#endif
}

// Others in each pass.
float number_of(ivec2 texel, int event) {
    return random_of(uvec3(texel, uint(event) ^ floatBitsToUint(params.shift.x))).x;
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
    walk w = walk(ray.origin, ray.direction, ray.flux, chain, chain - 1, params.chains == 1);
    float way = params.is_disk ? 0.0 : bvh_clearance(); // off the lamp's own surface
    vec3 origin = ray.origin + way * ray.direction;
    bool goes = dot(w.flux, vec3(1.0)) > 0.0;
    ray_leave = ray_end = ray_flux = vec4(0.0);
    for (int event = 0; event <= CHAIN_EVENTS && goes; event++) {
        bvh_hit hit = bvh_meet(origin, w.direction, goes);
        int row = smooth_row(hit.triangle);
        if (row == 0) {
            bool lands = hit.triangle >= 0;
            float far = lands ? hit.distance : max(ends_at(origin, w.direction), 0.0);
            goes = false;
            if (event > 0 && w.inner <= 0 && l.range_inverse2 * way * way < 1.0) {
                w.flux *= light_in_range(l, (way + hit.distance * float(lands)) * (way + hit.distance * float(lands)));
                ray_leave = vec4(w.place, uintBitsToFloat(packSnorm4x8(vec4(hit.normal, 0.5))));
                ray_end = vec4(origin + far * w.direction, lands ? RAY_LANDS : RAY_ESCAPES);
                ray_flux = vec4(w.flux, way);
            }
        } else {
            smooth_material m = smooth_material_at(row);
            vec3 met = origin + hit.distance * w.direction;
            vec3 normal = smooth_normal(hit.triangle, met, hit.normal);
            bool is_within = hit.back && m.kind == SMOOTH_IS_GLASS && !m.thin;
            w.flux *= is_within ? exp(-m.absorption * hit.distance)
                                : passes_outside(origin, w.direction, hit.distance);
            normal = dot(normal, w.direction) < 0.0 ? normal : hit.normal;
            if (m.kind == SMOOTH_IS_MIRROR)
                meet_mirror(w, m, normal, hit.normal, hit.back, event == 0);
            else
                meet_glass(w, m, normal, hit.back, event == 0, number_of(ivec2(gl_FragCoord.xy), event));
            way += hit.distance;
            w.place = met;
            float side = dot(w.direction, hit.normal) < 0.0 ? -1.0 : 1.0;
            origin = met + side * bvh_clearance() * hit.normal;
            goes = dot(w.flux, vec3(1.0)) > 0.0;
        }
    }
}
