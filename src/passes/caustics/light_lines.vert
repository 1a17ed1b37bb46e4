// Rays in a medium, as lines of the camera's picture. A line's weight is what makes a ray of flux a beam as wide as a pixel:
// length / (depth of one end * depth of the other * pixels that it is long * area of a pixel at depth 1); the depth of a
// place on it then cancels out. Published lines all have one weight [Dong 2011, eq. 8.3].
#include "lib/gbuffer.glsl"
#include "lib/light.glsl"
#include "lib/random.glsl"
#include "passes/caustics/rays.glsl"

layout(location = LOCATION_LIGHT) uniform int light_index;

out vec3 line_place;
out float line_way; // from where the ray left the last smooth surface, m
flat out vec3 line_flux, line_direction;

// Few of the lines of little light are drawn, for all of it: what a line costs does not depend on its light.
const float FULL_SHARE = 0.25, LEAST_CHANCE = 0.02;

struct segment {
    vec3 from, to;
    vec3 flux; // W; 0: there is none
};

#ifdef BETWEEN
segment segment_of(ivec2 texel, float number) {
    vec4 leave = texelFetch(ray_leaves, texel, 0), end = texelFetch(ray_ends, texel, 0);
    float red = floor(end.w / (BETWEEN_LEVELS + 1.0)), green = end.w - red * (BETWEEN_LEVELS + 1.0);
    vec3 shares = vec3(red, green, BETWEEN_LEVELS - red - green) / BETWEEN_LEVELS;
    return segment(leave.xyz, end.xyz, leave.w * shares);
}
#else
segment segment_of(ivec2 texel, float number) {
    vec3 from = texelFetch(ray_leaves, texel, 0).xyz, to = texelFetch(ray_ends, texel, 0).xyz;
    vec4 flux = texelFetch(ray_fluxes, texel, 0);
    float left = comes_by_chance(light_at(light_index), number) - flux.w, metres = distance(from, to);
    return segment(from, left < metres ? mix(from, to, left / metres) : to, left > 0.0 ? flux.rgb : vec3(0.0));
}
#endif

float chance_of(vec3 flux) {
    float sent = dot(light_at(light_index).intensity, vec3(1.0)) * params.measure;
    return clamp(dot(flux, vec3(1.0)) / (FULL_SHARE * sent), LEAST_CHANCE, 1.0);
}

void main() {
    ivec2 texel = ray_texel(gl_VertexID / 2);
    bool is_end = gl_VertexID % 2 == 1;
    uint in_pass = floatBitsToUint(params.shift.x); // others in each pass
    vec2 numbers = random_of(uvec3(texel, uint(LINE_NUMBERS + light_index) ^ in_pass));
    segment s = segment_of(texel, numbers.y);
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    line_place = line_flux = line_direction = vec3(0.0);
    line_way = 0.0;
    if (dot(s.flux, vec3(1.0)) <= 0.0)
        return;
    float chance = chance_of(s.flux);
    if (numbers.x >= chance)
        return;
    vec3 way = s.to - s.from;
    vec4 clip_a = camera.world_to_clip * vec4(s.from, 1.0), clip_b = camera.world_to_clip * vec4(s.to, 1.0);
    vec2 part = vec2(0.0, 1.0); // before the near plane
    float near = camera.orthographic ? 0.0 : 1.0001 * camera.near, rise = clip_b.w - clip_a.w;
    if (max(clip_a.w, clip_b.w) <= near)
        return;
    if (clip_a.w < near)
        part.x = (near - clip_a.w) / rise;
    if (clip_b.w < near)
        part.y = (near - clip_a.w) / rise;
    vec4 a = mix(clip_a, clip_b, part.x), b = mix(clip_a, clip_b, part.y);
    vec2 steps = 0.5 * params.size * (b.xy / b.w - a.xy / a.w);
    float pixels = max(abs(steps.x), abs(steps.y)), metres = length(way) * (part.y - part.x);
    if (metres <= 0.0)
        return;
    if (pixels < 1.0) { // along the view: it is one pixel long
        vec2 aside = abs(steps.x) > abs(steps.y) ? vec2(steps.x < 0.0 ? -1.0 : 1.0, 0.0)
                                                 : vec2(0.0, steps.y < 0.0 ? -1.0 : 1.0);
        b.xy = (a.xy / a.w + 2.0 * aside / params.size) * b.w;
        pixels = 1.0;
    }
    vec2 pixel = 2.0 * vec2(length(camera.right), length(camera.up)) / params.size;
    vec3 axis = view_axis(camera);
    float depths = camera.orthographic ? 1.0 : a.w * b.w / dot(axis, axis);
#if PUBLISHED
    line_flux = s.flux * params.line_weight / chance;
#else
    line_flux = s.flux * metres / (chance * depths * pixels * pixel.x * pixel.y);
#endif
    line_direction = normalize(way);
    line_way = length(way) * (is_end ? part.y : part.x);
    line_place = s.from + (is_end ? part.y : part.x) * way;
    gl_Position = is_end ? b : a;
}
