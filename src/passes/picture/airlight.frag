// Airlight of one light: what a medium scatters of it towards the camera. Steps along the pixel's ray are even in an
// angle psi, tan(scattering angle / 2) = tan(psi) / k with k = (1 + g) / (1 - g): of isotropic scattering in the angle
// seen from the light [Kulla and Fajardo 2012], of other g as dense as the phase function is pointed. The phase
// function times d(scattering angle) / d(psi) is then |(sin psi, k cos psi)| / (2 pi (1 + g)), which has no peak.
#include "lib/light.glsl"
#include "lib/medium.glsl"
#include "lib/gbuffer.glsl"
#include "shared/medium.h"

PASS_BLOCK(airlight_params, 16 + 4 * 16 * LIGHTS_MAX)

layout(binding = UNIT_MAP_DEPTH) uniform sampler2DArray maps;
layout(location = LOCATION_LIGHT) uniform int light_index;

layout(location = TARGET_RESULT) out vec4 scattered;

const float PI = 3.14159265358979;
const float CLEAR = 0.03; // of the width of a lamp's share: nearer to a place of it light does not grow

// From 0 to 1: the pixel's place in the pattern, neighbours far from each other [Bayer 1973].
float jitter_of(ivec2 pixel) {
    int y = pixel.y, x = pixel.x ^ y;
    int place = (x & 1) << 5 | (y & 1) << 4 | (x & 2) << 2 | (y & 2) << 1 | (x & 4) >> 1 | (y & 4) >> 2;
    return fract((float(place) + 0.5) / float(AIRLIGHT_PATTERN * AIRLIGHT_PATTERN) + params.turn);
}

// Whether the light comes to a point, in clip space of its view; what the view does not show hides nothing.
bool is_lit(vec4 clip, int layer) {
    ivec2 size = textureSize(maps, 0).xy;
    vec2 ndc = clip.xy / clip.w;
    ivec2 texel = clamp(ivec2((ndc * 0.5 + 0.5) * vec2(size)), ivec2(0), size - 1);
    float stored = texelFetch(maps, ivec3(texel, layer), 0).r;
    return stored == 0.0 || clip.z >= stored * clip.w || any(greaterThan(abs(ndc), vec2(1.0)));
}

// The light, and the mean over RGB of what it would be without shadows.
vec4 with_unshadowed(light l, vec3 sum, vec3 unshadowed, float factor) {
    vec3 scattered = medium.scattering * l.intensity * factor;
    return vec4(scattered * sum, dot(scattered, unshadowed) / 3.0);
}

// What panes let pass of light to that place of the ray, from so far away, and on to the camera.
vec3 panes_on_way(sight ray, float s, vec3 from_light, float away) {
    return PANES == 1 ? medium_panes(ray.origin + s * ray.direction, -from_light, away) *
                            medium_panes(ray.origin, ray.direction, s)
                      : vec3(1.0);
}

#if KIND == AIRLIGHT_DIRECTIONAL

// Steps are even in the light that passes the medium.
vec4 march(light l, sight ray, vec2 ends, int steps, float width, float jitter) {
    light_view v = light_view_at(l.first_view);
    vec4 clip_start = v.view.world_to_clip * vec4(ray.origin, 1.0);
    vec4 clip_along = v.view.world_to_clip * vec4(ray.direction, 0.0);
    float sigma = medium.mean_extinction, span = ends.y - ends.x, stopped = 1.0 - exp(-sigma * span);
    bool is_thin = sigma * span < 1e-3;
    vec3 sum = vec3(0.0), unshadowed = vec3(0.0);
    for (int i = 0; i < steps; i++) {
        float u = (float(i) + jitter) / float(steps), passed = 1.0 - u * stopped;
        float along = is_thin ? u * span : -log(passed) / sigma;
        float stands_for = is_thin ? span : stopped / (sigma * passed);
        float s = ends.x + along;
        vec2 before = medium_segment(ray.origin + s * ray.direction, -l.direction, 2.0 * medium.radius);
        vec3 passes = exp(-medium.extinction * (along + before.y - before.x));
        if (is_lit(clip_start + s * clip_along, v.layer))
            sum += passes * stands_for * panes_on_way(ray, s, l.direction, MEDIUM_FAR);
        unshadowed += passes * stands_for;
    }
    float g = medium.g, sharp = 1.0 + g * g + 2.0 * g * dot(l.direction, ray.direction);
    float phase = (1.0 - g * g) / (4.0 * PI * sharp * sqrt(sharp));
    return with_unshadowed(l, sum, unshadowed, phase / float(steps));
}

#else

// The part of the ray that is in a spot's cone, or before an area light.
vec2 in_cone(light l, sight ray, vec2 ends) {
    float cosine = l.type == LIGHT_TYPE_AREA ? 0.0 : l.cos_outer, cosine2 = cosine * cosine;
    vec3 from = ray.origin - l.position;
    float along = dot(ray.direction, l.direction), start = dot(from, l.direction);
    float a = along * along - cosine2, b = start * along - cosine2 * dot(from, ray.direction);
    float c = start * start - cosine2 * dot(from, from), root = sqrt(max(b * b - a * c, 0.0));
    a = abs(a) < 1e-6 ? (a < 0.0 ? -1e-6 : 1e-6) : a;
    vec2 met = vec2(-b - root, -b + root) / a;
    met = vec2(min(met.x, met.y), max(met.x, met.y));
    bool is_before = start + along * 0.5 * (met.x + met.y) > 0.0; // not of the cone behind the light
    vec2 inner = is_before && b * b > a * c ? met : vec2(0.0, -1.0);
    vec2 outer = along > 0.0 ? vec2(met.y, ends.y) : vec2(ends.x, met.x);
    vec2 cone = a < 0.0 ? inner : outer;
    return vec2(max(ends.x, cone.x), min(ends.y, cone.y));
}

vec2 in_range(light l, sight ray, vec2 ends) {
    float foot = dot(l.position - ray.origin, ray.direction);
    vec3 aside = l.position - ray.origin - foot * ray.direction;
    float half_chord = sqrt(max(1.0 / l.range_inverse2 - dot(aside, aside), 0.0));
    return vec2(max(ends.x, foot - half_chord), min(ends.y, foot + half_chord));
}

// Where a step's light starts: at a light sample, or anywhere on its lamp, so that samples are no dots in the air.
vec3 start_of(light l, int i, float jitter) {
    int flat_shape = int(params.sources[light_index].z);
    vec2 number = fract(vec2(jitter, 8.0 * jitter) + float(i) * vec2(0.7548776662, 0.5698402910));
    float turn = 2.0 * PI * number.y;
    vec2 on_disk = sqrt(number.x) * vec2(cos(turn), sin(turn));
    vec2 place = flat_shape == AIRLIGHT_FLAT_DISK ? on_disk : 2.0 * number - 1.0;
    vec3 start = params.middles[light_index].xyz + place.x * params.rights[light_index].xyz +
        place.y * params.ups[light_index].xyz;
    return flat_shape == AIRLIGHT_FLAT_NONE ? l.position : start;
}

float cone_of(light l, vec3 direction) {
    return l.type == LIGHT_TYPE_POINT ? 1.0 : light_cone(l, dot(direction, l.direction));
}

float psi_at(float from_foot, float h, float k) {
    float r = sqrt(from_foot * from_foot + h * h);
    return from_foot > 0.0 ? atan(k * (r + from_foot), h) : atan(k * h, r - from_foot);
}

vec4 march(light l, sight ray, vec2 ends, int steps, float width, float jitter) {
    if (l.type != LIGHT_TYPE_POINT)
        ends = in_cone(l, ray, ends);
    if (l.range_inverse2 > 0.0)
        ends = in_range(l, ray, ends);
    if (ends.x >= ends.y)
        return vec4(0.0);
    vec3 to_light = l.position - ray.origin;
    float foot = dot(to_light, ray.direction), k = (1.0 + medium.g) / (1.0 - medium.g);
    vec3 aside = to_light - foot * ray.direction;
    float least_h = 1e-6 * medium.radius; // of a light in the camera
    float h = sqrt(dot(aside, aside) + width * width + 1e-6 * dot(to_light, to_light) + least_h * least_h);
    float from = psi_at(ends.x - foot, h, k), psi_step = (psi_at(ends.y - foot, h, k) - from) / float(steps);
    float start = from + psi_step * jitter, entered = medium_segment(ray.origin, ray.direction, 1e30).x;
    vec2 at = vec2(cos(start), sin(start)), turn = vec2(cos(psi_step), sin(psi_step));
#if KIND == AIRLIGHT_SPOT
    light_view v = light_view_at(l.first_view);
    vec4 clip_start = v.view.world_to_clip * vec4(ray.origin, 1.0);
    vec4 clip_along = v.view.world_to_clip * vec4(ray.direction, 0.0);
#endif
    bool is_flat = params.sources[light_index].z > 0.0;
    vec3 sum = vec3(0.0), unshadowed = vec3(0.0);
    for (int i = 0; i < steps; i++) {
        float sine = at.y, cosine = k * at.x, square = sine * sine + cosine * cosine;
        float r = h * square / (2.0 * sine * cosine), s = foot - r * (cosine * cosine - sine * sine) / square;
        vec3 position = ray.origin + s * ray.direction, away = position - l.position;
        vec3 from_start = position - start_of(l, i, jitter);
        float distance2 = dot(away, away), start2 = dot(from_start, from_start);
        vec3 direction = away * inversesqrt(distance2);
        float strength = sqrt(square) * light_in_range(l, distance2);
        float near = is_flat ? r * r / (start2 + CLEAR * CLEAR * width * width) : 1.0;
        float from_lamp = strength * near * cone_of(l, from_start * inversesqrt(start2));
        strength *= cone_of(l, direction);
#if KIND == AIRLIGHT_SPOT
        bool lit = is_lit(clip_start + s * clip_along, v.layer);
#else
        light_view v = light_view_at(light_view_index(l, direction));
        bool lit = is_lit(v.view.world_to_clip * vec4(position, 1.0), v.layer);
#endif
        vec2 before = medium_segment(position, -direction, r);
        vec3 passes = exp(-medium.extinction * (s - entered + max(before.y - before.x, 0.0)));
#ifdef HAS_SLIDES
        passes *= light_slide(l, direction);
#endif
        if (lit)
            sum += passes * from_lamp * panes_on_way(ray, s, direction, r);
        unshadowed += passes * strength;
        at = vec2(at.x * turn.x - at.y * turn.y, at.x * turn.y + at.y * turn.x);
    }
    return with_unshadowed(l, sum, unshadowed, psi_step / (h * 2.0 * PI * (1.0 + medium.g)));
}

#endif

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    sight ray = sight_of(pixel);
    vec2 ends = medium_segment(ray.origin, ray.direction, ray.ray_length);
    vec4 source = params.sources[light_index];
    scattered = vec4(0.0);
    if (ends.x < ends.y)
        scattered =
            params.scale * march(light_at(light_index), ray, ends, int(source.x), source.y, jitter_of(pixel));
}
