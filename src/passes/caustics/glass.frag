// What glass and mirrors show: rays from the pixel through smooth surfaces, up to one that scatters. Where the picture
// shows the place that they meet, it tells the light there. Elsewhere shadow rays find the direct light, and rays by the
// cosine one bounce of indirect light.
#include "lib/light.glsl"
#include "lib/medium.glsl"
#include "lib/direction.glsl"
#include "lib/random.glsl"
#include "lib/gbuffer.glsl"
#include "shared/smooth.h"

PASS_BLOCK(glass_params, 32)

#include "passes/visibility/shadow_ray.glsl"
#include "passes/caustics/chain.glsl"

layout(binding = UNIT_GBUFFER_ALBEDO) uniform sampler2DArray albedos;
layout(binding = UNIT_GLASS_TRIANGLES) uniform samplerBuffer triangles;
layout(binding = UNIT_GLASS_SCREEN) uniform sampler2D screen_light; // A: the indirect light's part
#ifdef HAS_SKY
layout(binding = UNIT_GLASS_SKY) uniform sampler2D sky;
#endif

layout(location = TARGET_RESULT) out vec4 seen; // radiance; A: 1 and the indirect light's part

const float PI = 3.14159265;
const float LEAST_COSINE = 0.3; // between normals of one surface
const float LEAST_MATCH = 0.2;  // of the picture's four texels around a place
const float BACK = 4.0;         // rays start before the first surface, clearances
const int STEPS = 4;            // in a medium, of each segment

struct sent {
    vec3 direct, indirect; // radiance
};

// Two numbers from 0 to 1, others for each number that is asked for.
vec2 numbers(ivec2 pixel, int chain, int number) {
    return random_of(uvec3(pixel, uint(number + 64 * (chain + 8 * params.pass))));
}

light light_by_chance(float number) {
    return light_at(min(int(number * float(light_count)), light_count - 1));
}

vec3 reflected(bvh_hit hit) {
    vec4 texel = texelFetch(triangles, 2 * hit.triangle);
    return hit.back ? texel.rgb * texel.a : texel.rgb;
}

vec3 glow(bvh_hit hit) {
    bool dark = hit.back && texelFetch(triangles, 2 * hit.triangle).a == 0.0;
    return dark ? vec3(0.0) : params.scale * texelFetch(triangles, 2 * hit.triangle + 1).rgb;
}

// Radiance of a white surface there that rays by the cosine find: light of one bounce.
vec3 indirect_at(ivec2 pixel, int chain, vec3 place, vec3 normal, vec3 flat_normal) {
    const vec2 STEP = vec2(0.7548776662, 0.5698402910);
    vec2 start = numbers(pixel, chain, 63);
    vec3 right = perpendicular(normal), origin = place + bvh_clearance() * flat_normal, sum = vec3(0.0);
    for (int i = 0; i < params.rays; i++) {
        vec2 number = fract(start + float(i) * STEP);
        float turn = 2.0 * PI * number.y;
        vec3 aside = cos(turn) * right + sin(turn) * cross(normal, right);
        vec3 direction = sqrt(1.0 - number.x) * normal + sqrt(number.x) * aside;
        bvh_hit hit = bvh_meet(origin, direction, dot(direction, flat_normal) > 0.0);
        if (hit.triangle >= 0) {
            light l = light_by_chance(fract(number.x * 61.0 + number.y));
            vec3 lit = irradiance_from(l, origin + hit.distance * direction, hit.normal, hit.normal);
            sum += reflected(hit) * lit * medium_passes_along(origin, direction, hit.distance);
        }
    }
    return sum * (float(light_count) / (float(params.rays) * PI));
}

sent sent_outside_picture(ivec2 pixel, int chain, bvh_hit hit, vec3 place) {
    vec3 normal = smooth_normal(hit.triangle, place, hit.normal), albedo = reflected(hit), lit = vec3(0.0);
    for (int i = 0; i < light_count; i++)
        lit += irradiance_from(light_at(i), place, normal, hit.normal);
    return sent(albedo * lit / PI + glow(hit), albedo * indirect_at(pixel, chain, place, normal, hit.normal));
}

// What the texel shows where it is the place's surface, and 1.
void add_texel(ivec2 texel, vec3 place, vec3 normal, float weight, inout sent sum, inout float match) {
    if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, gbuffer_size())))
        return;
    surface s = gbuffer_surface(texel);
    bool smooth_or_black = texelFetch(albedos, ivec3(texel, 0), 0).rgb == vec3(0.0);
    if (!s.present || smooth_or_black || dot(s.normal, normal) < LEAST_COSINE ||
        abs(dot(s.position - place, normal)) > params.reach)
        return;
    vec4 shown = texelFetch(screen_light, texel, 0);
    sum.direct += weight * (1.0 - shown.a) * shown.rgb;
    sum.indirect += weight * shown.a * shown.rgb;
    match += weight;
}

// False: the picture does not show the place.
bool sent_in_picture(vec3 place, vec3 normal, out sent found) {
    vec4 clip = camera.world_to_clip * vec4(place, 1.0);
    vec2 at = (0.5 * clip.xy / clip.w + 0.5) * vec2(gbuffer_size()) - 0.5, part = fract(at);
    ivec2 texel = ivec2(floor(at));
    float match = 0.0;
    found = sent(vec3(0.0), vec3(0.0));
    if (clip.w <= camera.near || any(greaterThan(abs(clip.xy), vec2(clip.w))))
        return false;
    for (int i = 0; i < 4; i++) {
        ivec2 corner = ivec2(i & 1, i >> 1);
        vec2 weights = mix(1.0 - part, part, vec2(corner));
        add_texel(texel + corner, place, normal, weights.x * weights.y, found, match);
    }
    found.direct /= max(match, LEAST_MATCH);
    found.indirect /= max(match, LEAST_MATCH);
    return match >= LEAST_MATCH;
}

vec3 sky_along(vec3 direction) {
#ifdef HAS_SKY
    return params.sky_strength * panorama_texel(sky, direction, params.sky_turn);
#else
    return vec3(0.0);
#endif
}

// What the medium scatters into a segment outside glass, as the airlight of the first one, with few steps.
vec3 scattered_into(ivec2 pixel, int chain, int event, vec3 origin, vec3 direction, float metres) {
    vec3 sum = vec3(0.0);
#ifdef HAS_MEDIUM
    vec2 ends = medium_segment(origin, direction, metres);
    for (int i = 0; i < STEPS && ends.x < ends.y; i++) {
        vec2 number = numbers(pixel, chain, 64 * (event + 1) + i);
        light l = light_by_chance(number.y);
        float u = (float(i) + number.x) / float(STEPS), foot = dot(l.position - origin, direction);
        float h = max(distance(l.position, origin + foot * direction), 1e-4 * medium.radius);
        vec2 angles = atan((ends - foot) / h);
        float from_foot = h * tan(mix(angles.x, angles.y, u));
        bool directional = l.type == LIGHT_TYPE_DIRECTIONAL;
        float s = directional ? mix(ends.x, ends.y, u) : foot + from_foot;
        float stands_for = directional ? ends.y - ends.x : (h + from_foot * from_foot / h) * (angles.y - angles.x);
        vec3 incoming, power = arriving(l, origin + s * direction, vec3(0.0), stands_for, incoming);
        float g = medium.g, sharp = 1.0 + g * g + 2.0 * g * dot(incoming, direction);
        sum += power * medium_passes(s - ends.x) * ((1.0 - g * g) / (4.0 * PI * sharp * sqrt(sharp)));
    }
    sum *= medium.scattering * (float(light_count) / float(STEPS));
#endif
    return sum;
}

void add_end(ivec2 pixel, walk w, bvh_hit hit, inout sent sum) {
    vec3 place = w.origin + hit.distance * w.direction;
    sent found = sent(vec3(0.0), vec3(0.0));
    if (hit.triangle < 0)
        found.direct = sky_along(w.direction);
    else if (!sent_in_picture(place, hit.normal, found))
        found = sent_outside_picture(pixel, w.chain, hit, place);
    sum.direct += w.flux * found.direct;
    sum.indirect += w.flux * found.indirect;
}

// From the first surface on, whose hit that is.
void add_chain(ivec2 pixel, walk w, bvh_hit hit, inout sent sum) {
    bool goes = true;
    for (int event = 0; event <= CHAIN_EVENTS && goes; event++) {
        if (event > 0)
            hit = bvh_meet(w.origin, w.direction, goes);
        int row = smooth_row(hit.triangle);
        smooth_material m = smooth_material_at(max(row, 1));
        bool within = row > 0 && is_within(hit, m);
        w.flux *= event > 0 && !within && w.inner > 0 ? 0.0 : 1.0; // out without a reflection: another chain's
        if (event > 0 && !within) {
            sum.direct += w.flux * scattered_into(pixel, w.chain, event, w.origin, w.direction, hit.distance);
            w.flux *= medium_passes_along(w.origin, w.direction, hit.distance);
        }
        if (event > 0 && within)
            w.flux *= exp(-m.absorption * hit.distance);
        if (event > 0 && row > 0)
            sum.direct += w.flux * glow(hit);
        if (row > 0)
            walk_goes_on(w, hit, m, event == 0, numbers(pixel, w.chain, event).x);
        else
            add_end(pixel, w, hit, sum);
        goes = row > 0 && dot(w.flux, vec3(1.0)) > 0.0;
    }
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    bool is_black = texelFetch(albedos, ivec3(pixel, 0), 0).rgb == vec3(0.0);
    if (gbuffer_depth(pixel) == 0.0 || !is_black)
        discard;
    sight ray = sight_of(pixel);
    float before = BACK * bvh_clearance();
    vec3 start = ray.origin + (ray.ray_length - before) * ray.direction;
    bvh_hit first = bvh_meet(start, ray.direction, true);
    int row = smooth_row(first.triangle);
    if (row == 0 || first.distance > 4.0 * before)
        discard;
    smooth_material m = smooth_material_at(row);
    vec3 share = is_within(first, m) ? exp(-m.absorption * ray.ray_length) : vec3(1.0);
    int chains = m.kind == SMOOTH_IS_MIRROR ? 1 : params.chains;
    sent sum = sent(vec3(0.0), vec3(0.0));
    for (int chain = 0; chain < chains; chain++)
        add_chain(pixel, walk_from(start, ray.direction, share, chain, chains), first, sum);
    vec3 all = sum.direct + sum.indirect;
    float indirect = dot(sum.indirect, vec3(1.0)) / max(dot(all, vec3(1.0)), 1e-30);
    seen = vec4(all, 1.0 + min(indirect, 1.0));
}
