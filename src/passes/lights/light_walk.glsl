// Light walks from surface to surface: a ray in a direction by the cosine, and of its flux what the surface there reflects
// [Keller 1997]. At one of its surfaces, picked by flux times weight, it leaves the flux of all. Past WALK_SURE bounces chance
// ends a walk as often as surfaces absorb light, and walks that go on keep their flux [Arvo and Kirk 1990]: no light is lost.
// Includers define the functions that are declared here.
#include "passes/visibility/bvh.glsl"
#include "passes/lights/light_end.glsl"
#include "lib/random.glsl"
#include "lib/direction.glsl"
#include "shared/light_walk.h"

vec2 walk_number(int ray);
float walk_weight(vec3 position, vec3 normal);

struct walk {
    vec3 place, axis, carried;
    bool goes;
};

// Where walks leave their flux, so far.
struct walk_end {
    vec3 position, normal, flux;
    vec4 next; // where light goes from there; A: how far, -1: it meets nothing
    float all, own; // flux times weight, of all surfaces and of this one
};

const walk_end WALK_BEGIN = walk_end(vec3(0.0), vec3(0.0), vec3(0.0), vec4(0.0, 0.0, 0.0, -1.0), 0.0, 0.0);

// `pick` picks the surface, `chance` is another number for each walk. One more ray than bounces tells the next place.
void walk_on(walk w, int bounces, bool one_more, uvec2 chance, inout float pick, inout walk_end end) {
    int chosen = 0, last = one_more ? bounces + 1 : bounces;
    for (int bounce = 2; bounce <= last && w.goes; bounce++) {
        vec3 direction = cosine_direction(w.axis, walk_number(bounce - 2));
        vec3 albedo, arrives;
        vec4 specular;
        float away;
        surface s = light_end(w.place, direction, chance ^ uvec2(0u, bounce), albedo, specular, arrives, away);
        w.goes = s.present;
        if (w.goes && chosen == bounce - 1)
            end.next = vec4(s.position, distance(w.place, s.position));
        w.goes = w.goes && bounce <= bounces;
        if (w.goes) {
            float before = dot(w.carried, vec3(1.0));
            w.carried *= albedo * arrives;
            float own = dot(w.carried, vec3(1.0));
            w.goes = own > 0.0;
            if (bounce > WALK_SURE && w.goes) {
                w.goes = random_of(uvec3(bounce, chance)).x * before < own;
                w.carried *= before / own;
                own = w.goes ? before : 0.0;
            }
            own *= own > 0.0 ? walk_weight(s.position, s.normal) : 1.0;
            end.all += own;
            if (weighted_pick(own, end.all, pick)) {
                end.position = s.position;
                end.normal = s.normal;
                end.flux = w.carried;
                end.next.w = -1.0;
                end.own = own;
                chosen = bounce;
            }
            w.place = s.position + bvh_clearance() * s.normal;
            w.axis = s.normal;
        }
    }
}

// That of all surfaces.
vec3 walk_flux(walk_end end) {
    return end.flux * (end.all / max(end.own, 1e-30));
}
