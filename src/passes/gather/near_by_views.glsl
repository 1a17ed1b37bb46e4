// Whether something is between two near places, by what the light sees: a place of the way that lies a little behind
// that is within a caster. The light sees where near light comes from and what stands around it; what is behind that
// in its shadow it does not.
#include "passes/gather/near_lights.glsl"

const bool NEAR_IS_TESTED = true;
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
