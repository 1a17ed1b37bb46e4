// The lights and their views, and what a light sends in a direction.
#include "lib/view.glsl"
#include "shared/light.h"

// A light_block.
layout(std140, binding = BLOCK_LIGHTS) uniform light_uniforms {
    vec4 light_rows[LIGHTS_MAX * LIGHT_ROWS];
    vec4 light_view_rows[LIGHT_VIEWS_MAX * LIGHT_VIEW_ROWS];
    int light_count, single_view_count, face_view_count;
};

// A program may say how many lights there are, by its define LIGHTS.
light light_at(int i) {
#if defined(LIGHTS) && LIGHTS == 1
    i = 0; // known beforehand
#endif
    int row = i * LIGHT_ROWS;
    vec4 a = light_rows[row], b = light_rows[row + 1], c = light_rows[row + 2];
    vec4 d = light_rows[row + 3], e = light_rows[row + 4], f = light_rows[row + 5];
    vec4 g = light_rows[row + 6];
    vec4 h = light_rows[row + 7], slide = light_rows[row + 8];
    return light(a.xyz, a.w, b.xyz, floatBitsToInt(b.w), c.xyz, floatBitsToInt(c.w), d.xyz, d.w, e.xyz,
                 e.w, f.xyz, f.w, floatBitsToInt(g.x), floatBitsToInt(g.y), g.z, g.w, h.x,
                 floatBitsToInt(h.y), h.z, h.w, floatBitsToInt(slide.x), slide.y, slide.z, slide.w);
}

// A program may say which kinds of maps the lights have, by its define MAP_KINDS: 1 << LIGHT_MAP_... of each.
light_view light_view_at(int i) {
    int row = i * LIGHT_VIEW_ROWS;
    mat4 world_to_clip = mat4(light_view_rows[row], light_view_rows[row + 1], light_view_rows[row + 2],
                              light_view_rows[row + 3]);
    vec4 a = light_view_rows[row + 4], b = light_view_rows[row + 5], c = light_view_rows[row + 6];
    vec4 d = light_view_rows[row + 7];
    ivec4 e = floatBitsToInt(light_view_rows[row + 8]);
#if defined(MAP_KINDS) && MAP_KINDS < 3
    e.y = MAP_KINDS - 1; // the other kind's fetches fall away
#endif
    return light_view(view(world_to_clip, a.xyz, a.w, b.xyz, floatBitsToInt(b.w) != 0, c.xyz, false, d.xyz,
                           d.w),
                      e.x, e.y, e.z, 0);
}

// A spot's falloff by KHR_lights_punctual; an area light's cosine.
float light_cone(light l, float cos_angle) {
    if (l.type == LIGHT_TYPE_AREA)
        return max(cos_angle, 0.0);
    float span = max(0.001, l.cos_inner - l.cos_outer);
    float t = clamp((cos_angle - l.cos_outer) / span, 0.0, 1.0);
    return t * t;
}

// The factor of a slide or a profile in a unit direction; scene/lights/slide.c has the same.
#ifdef HAS_SLIDES
layout(binding = UNIT_SLIDES) uniform sampler2DArray slides;

vec3 slide_texel(light l, vec2 place) {
    vec2 last = vec2(l.slide_width, l.slide_height) - 1.0;
    return texelFetch(slides, ivec3(ivec2(clamp(place, vec2(0.0), last)), l.slide), 0).rgb;
}

// In texels: a turn about the axis, and half a turn away from it.
vec2 profile_place(light l, vec3 direction, float ahead) {
    vec2 aside = vec2(dot(direction, l.right), dot(direction, l.up));
    float turn = aside == vec2(0.0) ? 0.0 : fract(atan(aside.y, aside.x) / 6.2831853), away = atan(length(aside), ahead) / 3.1415927;
    return vec2(turn, away) * (vec2(l.slide_width, l.slide_height) - 1.0);
}

vec3 light_slide(light l, vec3 direction) {
    float ahead = dot(direction, l.direction);
    bool is_profile = l.slide_scale == 0.0;
    if (l.slide < 0 || (ahead <= 0.0 && !is_profile))
        return vec3(1.0);
    vec2 aside = vec2(dot(direction, l.right), -dot(direction, l.up)) * (l.slide_scale / ahead);
    vec2 place = (0.5 + 0.5 * aside) * vec2(l.slide_width, l.slide_height) - 0.5;
    if (is_profile)
        place = profile_place(l, direction, ahead);
    vec2 corner = floor(place), part = place - corner;
    vec3 above = mix(slide_texel(l, corner), slide_texel(l, corner + vec2(1.0, 0.0)), part.x);
    vec3 below = mix(slide_texel(l, corner + vec2(0.0, 1.0)), slide_texel(l, corner + vec2(1.0)), part.x);
    return mix(above, below, part.y);
}
#else
vec3 light_slide(light l, vec3 direction) {
    return vec3(1.0);
}
#endif

// Intensity in a unit direction, W/sr; not of a directional light.
vec3 light_intensity(light l, vec3 direction) {
    bool even = l.type == LIGHT_TYPE_POINT;
    vec3 intensity = l.intensity * (even ? 1.0 : light_cone(l, dot(direction, l.direction)));
#ifdef HAS_SLIDES
    intensity *= light_slide(l, direction);
#endif
    return intensity;
}

// What is left of its light at that squared distance, by KHR_lights_punctual.
float light_in_range(light l, float distance2) {
    float part2 = distance2 * l.range_inverse2;
    return max(1.0 - part2 * part2, 0.0);
}

// How far a ray's light comes, metres. Chance chooses it, so that on average each place has the light
// of its range.
float comes_by_chance(light l, float number) {
    return l.range_inverse2 > 0.0 ? sqrt(sqrt(1.0 - number) / l.range_inverse2) : 1e30;
}

// What a light sends towards a place, W/sr; a directional light across its direction, W/m2. direction: unit, from the light;
// distance2: 1 of a directional light.
vec3 light_towards(light l, vec3 place, out vec3 direction, out float distance2) {
    bool directional = l.type == LIGHT_TYPE_DIRECTIONAL;
    vec3 from = place - l.position;
    float away = length(from);
    direction = directional ? l.direction : from / away;
    distance2 = directional ? 1.0 : away * away;
    return directional ? l.intensity : light_intensity(l, direction) * light_in_range(l, distance2);
}

// Which view of the light sees in this direction: +x -x +y -y +z -z of six.
int light_view_index(light l, vec3 direction) {
#if defined(LIGHTS) && LIGHTS == 1 && defined(MAP_KINDS) && MAP_KINDS == 1
    return 0;
#endif
    if (l.view_count < 2)
        return l.first_view;
    vec3 a = abs(direction);
    int axis = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
    return l.first_view + 2 * axis + (direction[axis] < 0.0 ? 1 : 0);
}
