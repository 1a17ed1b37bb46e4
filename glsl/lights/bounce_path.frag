// Path (x, y) begins with a share of a VPL's light, and follows it from surface to surface: a ray in a direction by the
// cosine, and of its flux what the surface there reflects [Keller 1997]. At one of its surfaces, picked by flux, it leaves
// the flux of all. Of row 0, which leaves VPLs, one more ray tells where the light goes from there.
#include "visibility/bvh.glsl"
#include "lib/medium.glsl"
#include "lib/tangent.glsl"
#include "lib/vpl_texels.glsl"
#include "lib/weighted_pick.glsl"
#include "shared/bounce.h"
#include PATH_START

layout(binding = UNIT_PATH_NUMBERS) uniform sampler2D path_numbers;
layout(binding = UNIT_TRIANGLE_ALBEDOS) uniform samplerBuffer albedos; // A: 1 where backs reflect, too

layout(location = TARGET_BOUNCE_POSITION) out vec4 position; // A: the normal, packed
layout(location = TARGET_BOUNCE_NORMAL) out vec4 normal;
layout(location = TARGET_BOUNCE_FLUX) out vec4 flux;
layout(location = TARGET_BOUNCE_NEXT) out vec4 next; // A: how far from there, -1: it meets nothing

const float NOWHERE = 1e6; // of the radius: where paths are that leave nothing

vec3 cosine_direction(vec3 axis, vec2 number) {
    float turn = 6.28318530718 * number.y, radius = sqrt(number.x);
    vec3 right = perpendicular(axis);
    return sqrt(1.0 - number.x) * axis + radius * (cos(turn) * right + sin(turn) * cross(axis, right));
}

vec3 reflected(bvh_hit hit) {
    vec4 albedo = texelFetch(albedos, hit.triangle);
    return hit.back ? albedo.rgb * albedo.a : albedo.rgb;
}

vec2 number_at(ivec2 path, int number) {
    return texelFetch(path_numbers, ivec2(path.x, (BOUNCE_NUMBER_RAYS + params.bounces) * path.y + number), 0).rg;
}

void main() {
    ivec2 path = ivec2(gl_FragCoord.xy);
    int i = BOUNCE_ROWS * path.x + path.y;
    vec2 choice = number_at(path, BOUNCE_NUMBER_CHOICE);
    float vpls_per_path;
    vpl light = vpl_at(path_start(i, choice.x, vpls_per_path));
    vec3 place = light.position + params.start * light.normal, axis = light.normal;
    vec3 carried = light.flux * vpls_per_path;
    bool goes = light.reach > 0.0;
    float pick = choice.y, all = 0.0, left = 0.0;
    int chosen = 0;
    next = vec4(0.0, 0.0, 0.0, -1.0);
    position = vec4(vec3(NOWHERE * params.radius), 0.0);
    normal = flux = vec4(0.0);
    int last = path.y == 0 ? params.bounces + 1 : params.bounces;
    for (int bounce = 2; bounce <= last; bounce++) {
        vec3 direction = cosine_direction(axis, number_at(path, BOUNCE_NUMBER_RAYS + bounce - 2));
        bvh_hit hit = bvh_meet(place, direction, goes);
        goes = goes && hit.triangle >= 0;
        if (goes && chosen == bounce - 1)
            next = vec4(place + hit.distance * direction, hit.distance);
        goes = goes && bounce <= params.bounces;
        if (goes) {
            vec3 met = place + hit.distance * direction;
            carried *= reflected(hit) * medium_passes_along(place, direction, hit.distance);
            float own = dot(carried, vec3(1.0));
            goes = own > 0.0;
            all += own;
            if (weighted_pick(own, all, pick)) {
                // No packed normal is a float that is not a number.
                position = vec4(met, uintBitsToFloat(packSnorm4x8(vec4(hit.normal, 0.5))));
                next.w = -1.0;
                normal = vec4(hit.normal, 0.0);
                flux = vec4(carried, 0.0);
                left = own;
                chosen = bounce;
            }
            place = met + bvh_clearance() * hit.normal;
            axis = hit.normal;
        }
    }
    flux *= all / max(left, 1e-30);
}
