// A ray that goes on at glass and mirrors. What includes this has included lib/medium.glsl and passes/visibility/bvh.glsl.
//
// A ray that meets glass divides: of a number of chains, 0 is reflected outside, 1 goes through, and chain k is reflected
// k - 1 times within where it could leave. Where the last one could leave, a number picks whether it does, and so it does
// for all chains at the glass after that: no light is lost, and neighbours mostly take the same way. Of a ray that begins
// in glass 0 leaves it and 1 is reflected.
#include "shared/smooth.h"

// Smooth surfaces as rays meet them: material and shading normal of a triangle.
layout(binding = UNIT_TRIANGLE_ROWS) uniform usamplerBuffer triangle_rows;
layout(binding = UNIT_SMOOTH_MATERIALS) uniform samplerBuffer smooth_materials;
layout(binding = UNIT_CORNERS) uniform usamplerBuffer corners;
layout(binding = UNIT_CORNER_POSITIONS) uniform samplerBuffer corner_positions;
layout(binding = UNIT_CORNER_NORMALS) uniform isamplerBuffer corner_normals;

struct smooth_material {
    vec3 base, absorption; // absorption in 1/m
    int kind;              // SMOOTH_IS_...
    float refraction;      // index
    float passes;          // share of the light that enters and is not scattered
    bool thin;
    bool two_sided; // a mirror that reflects from behind, too
};

// 0: the surface is not smooth.
int smooth_row(int triangle) {
    return triangle < 0 ? 0 : int(texelFetch(triangle_rows, triangle).r);
}

smooth_material smooth_material_at(int row) {
    int texel = (row - 1) * SMOOTH_TEXELS;
    vec4 a = texelFetch(smooth_materials, texel), b = texelFetch(smooth_materials, texel + 1);
    vec4 c = texelFetch(smooth_materials, texel + 2);
    return smooth_material(a.rgb, b.rgb, int(a.a), b.a, c.x, c.y > 0.0, c.z > 0.0);
}

// At a point of the triangle, on the side of `facing`.
vec3 smooth_normal(int triangle, vec3 at, vec3 facing) {
    ivec3 vertices;
    vec3 place[3], normal[3];
    for (int i = 0; i < 3; i++) {
        int vertex = int(texelFetch(corners, 3 * triangle + i).r);
        place[i] = texelFetch(corner_positions, vertex).xyz;
        normal[i] = vec3(texelFetch(corner_normals, vertex).xyz);
    }
    vec3 across = cross(place[1] - place[0], place[2] - place[0]);
    float u = dot(cross(place[1] - at, place[2] - at), across), v = dot(cross(place[2] - at, place[0] - at), across);
    float w = dot(across, across) - u - v;
    vec3 n = normalize(u * normal[0] + v * normal[1] + w * normal[2]);
    return dot(n, facing) < 0.0 ? -n : n;
}

struct walk {
    vec3 origin, direction; // of its next segment
    vec3 place;             // where it has met the last smooth surface
    vec3 flux;              // or the share that is left of what it sees
    int chain, chains;
    int inner; // reflections within that are left
    bool picks;
};

walk walk_from(vec3 origin, vec3 direction, vec3 flux, int chain, int chains) {
    return walk(origin, direction, origin, flux, chain, chains, chain - 1, chains == 1);
}

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
    bool is_within = back && !m.thin, total = square <= 0.0, starts_within = is_first && is_within && !w.picks;
    if (starts_within)
        w.flux *= w.chain > (total ? 0 : 1) ? 0.0 : 1.0;
    bool picks = w.picks, turns = number < reflects;
    if (!picks && is_first)
        turns = w.chain == (is_within ? 1 : 0);
    else if (!picks && is_within && !total) {
        turns = w.inner > 0;
        picks = !turns && w.chain == w.chains - 1;
        turns = picks ? number < reflects : turns;
    } else
        picks = true;
    w.picks = w.picks || starts_within || (is_first ? w.chain == 0 : is_within && !total && !turns);
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

bool is_within(bvh_hit hit, smooth_material m) {
    return hit.back && m.kind == SMOOTH_IS_GLASS && !m.thin;
}

// Of a segment that has come to a smooth surface.
void walk_goes_on(inout walk w, bvh_hit hit, smooth_material m, bool is_first, float number) {
    vec3 met = w.origin + hit.distance * w.direction;
    vec3 normal = smooth_normal(hit.triangle, met, hit.normal);
    normal = dot(normal, w.direction) < 0.0 ? normal : hit.normal;
    if (m.kind == SMOOTH_IS_MIRROR)
        meet_mirror(w, m, normal, hit.normal, hit.back, is_first);
    else
        meet_glass(w, m, normal, hit.back, is_first, number);
    w.place = met;
    w.origin = met + (dot(w.direction, hit.normal) < 0.0 ? -1.0 : 1.0) * bvh_clearance() * hit.normal;
}
