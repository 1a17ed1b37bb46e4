// The near field of the lit surfaces: what VPLs, a spacing apart, cannot resolve. Each pixel gathers from
// the reflective shadow map around its own place in each light's view [Dachsbacher and Stamminger 2005],
// log-polar, so that a corner is resolved at every distance. OCCLUSION says how something between is found
// (shared/gather.h).
//     E = 1/n sum_j  rho I / pi  cos cos / d^2  near(d)  dw_j
// A draw fills one tile, whose pixels share their samples, as in the gather.
#include "lib/gbuffer.glsl"
#include "passes/gather/vpl_terms.glsl"
#include "passes/gather/near_light.glsl"
#include "passes/gather/receiver.glsl"
#include "passes/gather/representative.glsl"
#include "lib/medium.glsl"
#include "lib/vpl_shares.glsl"
#include "shared/gather.h"
#include "shared/vpl.h"

PASS_BLOCK(near_field_params, 48)

layout(location = LOCATION_SLOT) uniform ivec4 slot; // samples, in its second; the tile's place in the pattern
// What the tile's first sample is turned by, cosine and sine; what numbers have more than integers; one over the count.
layout(location = LOCATION_NEAR_SHIFT) uniform vec4 shift;
// The lights that this tile takes, and each one's weight: of a group of many one stands for all, but for what is on
// a list.
layout(location = LOCATION_SLOT_LIGHT_COUNT) uniform int slot_light_count;
layout(location = LOCATION_SLOT_LIGHTS) uniform vec2 slot_lights[LIGHTS];

layout(location = TARGET_RESULT) out vec4 irradiance;

const float PI = 3.14159265358979;
// Places are known to a texel's middle, and other passes have others: what is nearer than this, over a texel's width,
// would shine without a bound, and light from there is lost.
const float NEAREST = FACETS == 1 ? 0.25 : 1.0;

// What reaches the receiver from a sample where nothing is between, per unit of ndc area and spread of the view.
struct near_arrival {
    vec3 light, position; // of the sample
    int view_index;       // of the view that has it
};

// bool is_between(s, sample, any): a sample without light, not any, is at the receiver.
#if OCCLUSION == NEAR_BY_VIEWS
// Whether something is between two near places, by what the light sees: a place of the way that lies a little behind
// that is within a caster. The light sees where near light comes from and what stands around it; what is behind that
// in its shadow it does not.
const int NEAR_PARTS = 4;
// Casters are as deep as this, over the way's length: a little more than between two places.
const float NEAR_CASTER_DEPTH = 0.3;
// In texels of the view: a surface aslant is off its texel's middle by so much; and ways that have less than a texel
// from place to place are not known.
const float NEAR_BIAS = 0.25;
const float NEAR_SHORTEST = 4.0;

// Where the view has a position: ndc times w, w, and metres along its axis.
vec4 place_in_view(view v, vec3 position) {
    vec4 clip = v.world_to_clip * vec4(position, 1.0);
    return vec4(clip.xyw, v.orthographic ? (1.0 - clip.z) * v.far : clip.w);
}

bool is_between(surface s, near_arrival representative, bool any) {
    vec3 from = s.position, to = representative.position;
    light_view seen = light_view_at(representative.view_index);
    int size = near_size(seen.kind);
    float way = distance(from, to), deep = NEAR_CASTER_DEPTH * way;
    vec4 first = place_in_view(seen.view, from), last = place_in_view(seen.view, to);
    float texel = 2.0 * length(seen.view.right) / float(size); // its width, over w
    bool hidden = false;
    // A count: a software rasteriser executes both sides of a branch.
    int parts = any && way > NEAR_SHORTEST * texel * first.z ? NEAR_PARTS : 0;
    for (int i = 1; i < parts && !hidden; i++) {
        vec4 place = mix(first, last, float(i) / float(NEAR_PARTS));
        float z = near_fetch(seen, near_texel(place.xy / place.z, size)).z, behind = place.w - z;
        hidden = z > 0.0 && behind > NEAR_BIAS * texel * place.z && behind < deep;
    }
    return hidden;
}
#elif OCCLUSION == NEAR_BY_RAYS
#include "passes/visibility/bvh.glsl"

bool is_between(surface s, near_arrival representative, bool any) {
    return is_blocked(s.position, s.normal, representative.position);
}
#else
bool is_between(surface s, near_arrival representative, bool any) {
    return false;
}
#endif

#ifdef HAS_NORMAL_MAPS
vec3 receiver_facet = vec3(0.0); // the normal of the triangle that the receiver lies on
#endif

// Where the light's view of that number has the point `ndc`.
near_arrival arrival_from(surface receiver, light l, int index, vec2 ndc, float reach) {
    light_view seen = light_view_at(index);
    view v = seen.view;
    float measure = 1.0;
    if ((MAP_KINDS & (1 << LIGHT_MAP_FACE)) != 0) {
        // The point may lie beyond the edge of a cube's face: another face has it, and its own solid angle per unit of
        // its ndc area. Both are the cube of the ray's cosine.
        vec3 ray = v.forward + ndc.x * v.right + ndc.y * v.up;
        int other = light_view_index(l, ray);
        seen = light_view_at(other);
        v = seen.view;
        if (other != index) {
            vec4 clip = v.world_to_clip * vec4(ray, 0.0);
            ndc = clip.xy / clip.w;
            measure = 1.0 / (clip.w * clip.w * clip.w);
        }
        index = other;
    }
    int size = near_size(seen.kind);
    ivec2 texel = near_texel(ndc, size);
    near_light near = near_fetch(seen, texel);
    vec3 position = view_position_at(v, (vec2(texel) + 0.5) / float(size) * 2.0 - 1.0, near.z);
    vec3 to_sample = (position - receiver.position) * params.inverse_radius;
    float distance2 = dot(to_sample, to_sample);
    vec3 normal = octahedral_unfold(near.normal_code);
    float cosines = max(dot(receiver.normal, to_sample), 0.0) * max(-dot(normal, to_sample), 0.0);
#ifdef HAS_NORMAL_MAPS
    cosines *= above_horizon(receiver_facet, to_sample);
#endif
    // One division for the normal's length, the share and the distance.
    float reach2 = reach * near.spacing * reach * near.spacing;
    float scaled4 = distance2 * distance2 * length(normal), inverse = 1.0 / max(scaled4 * reach2, 1e-37);
    float share = near_share_at(distance2 * scaled4 * inverse);
    if (FACETS == 1) {
        float texel = 2.0 / float(size) * length(v.right) * (v.orthographic ? 1.0 : near.z);
        float nearest = NEAREST * texel * params.inverse_radius;
        cosines *= min(distance2 / (nearest * nearest), 1.0);
    }
    // No branches: a software rasteriser executes both sides.
    bool seen_lit = all(lessThan(abs(ndc), vec2(1.0))) && near.z > 0.0 && cosines > 0.0;
    vec3 light = near.power * (seen_lit ? cosines * inverse * reach2 * share * measure : 0.0);
    light *= medium_passes_between(position, receiver.position);
    return near_arrival(light, position, index);
}

// Where samples of one light lie, in the view of that number: on a spiral around the receiver, each turned and farther
// out by as much as the one before (base/spiral.h). A step is one complex product: a software rasteriser would fetch
// what it read from a table for each pixel by itself.
struct near_spiral {
    int view_index;
    float reach;
    vec2 center; // ndc
    vec2 at;     // of the next sample, from there, in widths of the view
    mat2 step;
    float aspect; // of a width over a height
};

near_arrival next_arrival(surface s, light l, inout near_spiral around) {
    vec2 ndc = around.center + vec2(around.at.x, around.at.y * around.aspect);
    near_arrival arrival = arrival_from(s, l, around.view_index, ndc, around.reach);
    arrival.light *= dot(around.at, around.at); // log-polar density: 1 / (2 pi r^2 span) per ndc area
    around.at = around.step * around.at;
    return arrival;
}

vec3 light_together(surface s, light l, inout near_spiral around, int count, float random) {
    vec3 sum = vec3(0.0);
    float strength = 0.0;
    near_arrival representative = near_arrival(vec3(0.0), s.position, around.view_index);
    for (int i = 0; i < count; i++) {
        near_arrival own = next_arrival(s, l, around);
        float own_strength = dot(own.light, vec3(1.0));
        sum += own.light;
        strength += own_strength;
        bool taken = weighted_pick(own_strength, strength, random);
        representative.light = taken ? own.light : representative.light;
        representative.position = taken ? own.position : representative.position;
        representative.view_index = taken ? own.view_index : representative.view_index;
    }
    bool hidden = is_between(s, representative, strength > 0.0);
    return group_light(sum, strength, representative.light, hidden ? 0.0 : 1.0);
}

vec3 light_of_samples(surface s, light l, near_spiral around, int count, float random) {
    vec3 sum = vec3(0.0);
    if (OCCLUSION != NEAR_UNOCCLUDED)
        for (int i = 0; i < count; i += NEAR_TOGETHER) {
            sum += light_together(s, l, around, min(NEAR_TOGETHER, count - i), random);
            random = group_random_next(random);
        }
    else
        for (int i = 0; i < count; i++)
            sum += next_arrival(s, l, around).light;
    return sum;
}

// Of one light, where there is something that receives it.
vec3 near_field(surface s, bool receives, light l, vpl_share share, float random) {
    int index = light_view_index(l, s.position - l.position);
    light_view seen = light_view_at(index);
    view v = seen.view;
    vec4 clip = v.world_to_clip * vec4(s.position, 1.0);
    vec2 center = clip.xy / clip.w;
    // The reach of the widest VPL, in ndc.
    float radius = share.reach * sqrt(share.measure / VPL_COSINE_MIN) / length(v.right);
    float aspect = length(v.right) / length(v.up);
    float least = NEAREST / float(near_size(seen.kind)), span = log(radius / least);
    // A count and no branch around the loop, which a software rasteriser would keep books of at each step.
    bool reached = receives && clip.w > 0.0 && all(lessThanEqual(abs(center), vec2(1.0 + radius))) && span > 0.0;
    float step = span * shift.w;
    vec2 next = exp(step) * params.next_turn;
    near_spiral around = near_spiral(index, share.reach, center, least * exp(step * shift.z) * shift.xy,
                                     mat2(next, -next.y, next.x), aspect);
    vec3 sum = light_of_samples(s, l, around, reached ? slot.y : 0, random);
    float spread = length(v.right) * length(v.up);
    float weight = 2.0 * PI * span * aspect * spread / float(slot.y);
    return reached ? sum * (weight / PI) : vec3(0.0);
}

void main() {
    irradiance = vec4(0.0);
    ivec2 pixel;
    bool receives = receiver_pixel(params.pattern, slot.zw, pixel);
    surface s = receiver_surface(pixel);
    receives = receives && s.present;
    float random = group_random(pixel, params.turn);
#ifdef HAS_NORMAL_MAPS
    receiver_facet = receiver_triangle(s, pixel);
#endif
#if LIGHTS == 1 // or none
    irradiance.rgb = near_field(s, receives && slot_light_count > 0, light_at(0), vpl_share_at(0), random);
#else
    for (int i = 0; i < slot_light_count; i++) {
        int index = int(slot_lights[i].x);
        irradiance.rgb += slot_lights[i].y * near_field(s, receives, light_at(index), vpl_share_at(index), random);
    }
#endif
}
