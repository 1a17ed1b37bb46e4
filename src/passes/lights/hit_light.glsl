// The radiance of a surface that a ray has met, by one light chosen by what it gives there.
#include "lib/lobe_albedo.glsl"
#include "lib/medium.glsl"
#include "lib/rsm.glsl"
#include "passes/visibility/bvh.glsl"

#ifdef HAS_SAMPLED
#include "passes/lights/vpl_sampled.glsl"
#endif
#ifdef HAS_SKY
#include "passes/lights/sky_pieces.glsl"
#define IS_SKY(light) has_sky_pieces(light)

void take_sky_direction(int light, float random, out vec3 incoming, out vec3 power) {
    int piece = min(int(random * float(SKY_PIECES)), SKY_PIECES - 1);
    vec3 right = sky_piece_row(light, piece, 1).xyz, up = sky_piece_row(light, piece, 2).xyz;
    incoming = normalize(cross(up, right));
    power = sky_piece_row(light, piece, 3).xyz;
}
#else
#define IS_SKY(light) false

void take_sky_direction(int light, float random, out vec3 incoming, out vec3 power) {
}
#endif

// Of a light sample of a sky that lies behind the surface: directions of its pieces may not.
const float SKY_COSINE_MIN = 0.1;
// The light's map has a surface where it lies within so many of the map's texels of its plane, and faces alike.
const float MAP_TEXELS = 2.0;
const float MAP_COSINE = 0.5;
const float END_ALPHA_MIN = 0.2;
// Makes a second random number of one.
const float SAMPLE_TURNS = 4096.0;

struct chosen_light {
    int index;
    float share;             // chance that it is chosen
    float cosine, distance2; // distance2 1: a directional light
    int sampled;             // number of a sampled light; -1: another
    float probability;       // of a sampled light among all
};

#ifdef HAS_SAMPLED
bool is_many(light l) {
    return l.type == LIGHT_TYPE_MANY;
}

light sampled_light_middle(int i) {
    return sampled_light_piece(i, vec2(0.5));
}

int sample_light(surface end, float random, out float probability) {
    return light_tree_sample(end.position, end.normal, random, probability);
}
#else
bool is_many(light l) {
    return false;
}

light sampled_light_middle(int i) {
    return light_at(0);
}

int sample_light(surface end, float random, out float probability) {
    probability = 1.0;
    return -1;
}
#endif

// Luminance of the irradiance from all of a light.
float most_from(light l, bool is_sky, surface end, out float cosine, out float distance2) {
    vec3 incoming, power = light_towards(l, end.position, incoming, distance2);
    cosine = max(-dot(end.normal, incoming), is_sky ? SKY_COSINE_MIN : 0.0);
    return dot(power, vec3(1.0)) * cosine / distance2;
}

chosen_light choose_light(surface end, float random) {
    chosen_light chosen = chosen_light(0, 0.0, 0.0, 1.0, -1, 1.0);
    float sum = 0.0, taken = 0.0;
    for (int i = 0; i < (end.present ? light_count : 0); i++) {
        float cosine, distance2, probability = 1.0;
        light l = light_at(i);
        int sampled = is_many(l) ? sample_light(end, fract(random * SAMPLE_TURNS), probability) : -1;
        if (sampled >= 0)
            l = sampled_light_middle(sampled);
        float most = most_from(l, IS_SKY(i), end, cosine, distance2) / probability;
        sum += most;
        if (weighted_pick(most, sum, random)) {
            chosen = chosen_light(i, 0.0, cosine, distance2, sampled, probability);
            taken = most;
        }
    }
    chosen.share = taken / max(sum, 1e-30);
    return chosen;
}

// Takes texture, normal and lobe of the surface from the light's map where that has it.
void take_from_map(light l, inout surface end, inout vec3 albedo, inout vec4 code) {
    light_view v = light_view_at(light_view_index(l, end.position - l.position));
    ivec2 size = rsm_size(v.kind), texel;
    bool inside = view_shows(v.view, end.position, size, texel);
    surface seen = rsm_surface(v, texel);
    float depth = v.view.orthographic ? 1.0 : dot(end.position - v.view.origin, v.view.forward);
    float wide = 2.0 * length(v.view.right) * depth / float(size.x);
    if (!inside || !seen.present || dot(seen.normal, end.normal) < MAP_COSINE ||
        abs(dot(seen.position - end.position, end.normal)) > MAP_TEXELS * wide)
        return;
    end.normal = seen.normal;
    albedo = rsm_albedo(v, texel);
    code = rsm_specular(v, texel);
}

// What of the light's irradiance the surface sends to the receiver, 1/sr times the light's cosine there. Few rays would
// find a narrow highlight, as spots. So its lobe is widened by the receiver's [Kaplanyan and Dachsbacher 2013], and is
// END_ALPHA_MIN at least. Diffuse is what the albedo has beside the specular part (passes/picture/geometry.frag).
vec3 end_reflects(surface end, vec3 albedo, vec4 code, vec3 to_light, vec3 to_receiver, float receiver_alpha) {
    vec4 specular = specular_decode(code);
    vec3 f90 = specular_grazing(code);
    float cosine = max(dot(end.normal, to_light), 0.0);
    vec3 lobe = specular_albedo(specular.rgb, f90, specular_alpha(specular.a), cosine);
    float alpha = clamp(length(vec2(specular.a * specular.a, receiver_alpha)), END_ALPHA_MIN, 1.0);
    specular_surface s = specular_surface(specular.rgb, f90, alpha, end.normal, facing(end.normal, to_receiver));
    return max(albedo - lobe, 0.0) * (cosine / 3.14159265) +
           (specular.rgb == vec3(0.0) ? vec3(0.0) : specular_brdf(s, to_light));
}

// Radiance by the chosen light, over the chance that it is chosen. code: the specular part of the albedo. A sky's light sample has many directions: `random`
// takes one.
vec3 hit_radiance(surface end, vec3 albedo, vec4 code, chosen_light chosen, vec3 to_receiver, float receiver_alpha,
                  float random) {
    light l = light_at(chosen.index);
    if (chosen.sampled >= 0)
        l = sampled_light_middle(chosen.sampled);
    bool directional = l.type == LIGHT_TYPE_DIRECTIONAL;
    float distance2;
    vec3 incoming, power = light_towards(l, end.position, incoming, distance2), normal = end.normal;
    if (IS_SKY(chosen.index))
        take_sky_direction(chosen.index, random, incoming, power);
    else if (chosen.sampled < 0)
        take_from_map(l, end, albedo, code);
    vec3 reflects = end_reflects(end, albedo, code, -incoming, to_receiver, receiver_alpha);
    vec3 light_place = directional ? end.position - params.farthest * incoming : l.position;
    bool asks = reflects != vec3(0.0);
    bool hidden = is_blocked(end.position, normal, asks ? light_place : end.position); // no way, no ray
    power *= medium_passes_light(end.position, incoming, !directional, distance2);
    return hidden ? vec3(0.0) : reflects * power / (distance2 * chosen.share * chosen.probability);
}
