// Light that rays bring to a surface, as the camera sees it: a triangle between three rays, or with SPLATS a round spot of one,
// as a triangle around it. What would be much smaller than a pixel becomes one pixel that takes all of its flux.
#include "lib/gbuffer.glsl"
#include "passes/caustics/rays.glsl"

flat out vec3 patch_irradiance, patch_normal, patch_middle;

vec2 pixel_of(vec4 clip) {
    return (0.5 * clip.xy / clip.w + 0.5) * params.size;
}

vec4 clip_of(vec3 place) {
    return camera.world_to_clip * vec4(place, 1.0);
}

// Surface that a pixel shows of a plane there, m2.
float footprint(vec3 place, vec3 normal) {
    vec2 pixel = 2.0 * vec2(length(camera.right), length(camera.up)) / params.size;
    vec3 axis = view_axis(camera);
    float ahead = dot(axis, axis);
    vec3 along = camera.orthographic ? camera.forward : place - camera.origin;
    float depth = camera.orthographic ? 1.0 : dot(along, axis) / ahead;
    float facing = max(abs(dot(normal, along)), 1e-6 * length(along));
    return pixel.x * pixel.y * depth * depth * (dot(along, axis) / sqrt(ahead)) / facing;
}

// The corner of a triangle that covers the middle of the place's pixel, and of no other.
vec4 pixel_corner(vec3 place, int corner) {
    vec4 clip = clip_of(place);
    vec2 middle = floor(pixel_of(clip)) + 0.5;
    middle += corner == 0 ? vec2(-0.4) : corner == 1 ? vec2(0.8, -0.4) : vec2(-0.4, 0.8);
    return vec4((middle / params.size * 2.0 - 1.0) * clip.w, clip.z, clip.w);
}

void be_nowhere() {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    patch_irradiance = patch_normal = patch_middle = vec3(0.0);
}

void set_surface(ivec2 texel, vec3 middle) {
    patch_normal = end_normal(texelFetch(ray_leaves, texel, 0));
    patch_middle = middle;
}

#ifdef SPLATS
layout(binding = UNIT_SPLATS) uniform sampler2D splats;

flat out float splat_radius; // metres; 0: one pixel

const float SMALL = 0.7; // pixels

void main() {
    ivec2 texel = ray_texel(gl_VertexID / 3);
    int corner = gl_VertexID % 3;
    be_nowhere();
    splat_radius = 0.0;
    vec4 splat = texelFetch(splats, texel, 0);
    if (splat.w <= 0.0)
        return;
    vec3 middle = texelFetch(ray_ends, texel, 0).xyz;
    if (clip_of(middle).w <= camera.near)
        return;
    set_surface(texel, middle);
    float area = footprint(middle, patch_normal);
    if (splat.w < SMALL * sqrt(area)) {
        gl_Position = pixel_corner(middle, corner);
        patch_irradiance = splat.rgb / area;
        return;
    }
    splat_radius = splat.w;
    vec3 right = normalize(abs(patch_normal.y) < 0.9 ? cross(patch_normal, vec3(0.0, 1.0, 0.0))
                                                     : cross(patch_normal, vec3(1.0, 0.0, 0.0)));
    vec2 aside = corner == 0 ? vec2(0.0, 2.0) : vec2(corner == 1 ? -1.7320509 : 1.7320509, -1.0);
    gl_Position = clip_of(middle + splat.w * (aside.x * right + aside.y * cross(patch_normal, right)));
    patch_irradiance = splat.rgb / (3.14159265 * splat.w * splat.w);
}
#else
layout(binding = UNIT_PATCHES) uniform sampler2D patches[2];

const float SMALL = 0.25;      // pixels
const float SMALL_WIDTH = 4.0; // likewise

void main() {
    ivec2 texel = ray_texel(gl_VertexID / 6);
    int corner = gl_VertexID % 3;
    bool second = gl_VertexID % 6 >= 3;
    be_nowhere();
    vec4 flux = second ? texelFetch(patches[1], texel, 0) : texelFetch(patches[0], texel, 0);
    if (flux.w == 0.0)
        return;
    vec3 a = texelFetch(ray_ends, texel, 0).xyz, b = texelFetch(ray_ends, texel + ivec2(1), 0).xyz;
    vec3 c = texelFetch(ray_ends, texel + (second ? ivec2(0, 1) : ivec2(1, 0)), 0).xyz;
    vec4 clip_a = clip_of(a), clip_b = clip_of(b), clip_c = clip_of(c);
    vec3 middle = (a + b + c) / 3.0;
    set_surface(texel, middle);
    gl_Position = corner == 0 ? clip_a : corner == 1 ? clip_b : clip_c;
    patch_irradiance = flux.rgb / max(0.5 * length(cross(b - a, c - a)), 1e-30);
    if (min(clip_a.w, min(clip_b.w, clip_c.w)) <= camera.near)
        return;
    vec2 p = pixel_of(clip_a), q = pixel_of(clip_b), r = pixel_of(clip_c);
    vec2 width = max(p, max(q, r)) - min(p, min(q, r)), e = q - p, f = r - p;
    float pixels = 0.5 * abs(e.x * f.y - e.y * f.x);
    vec3 in_pixel = flux.rgb / footprint(middle, patch_normal);
    if (max(width.x, width.y) < SMALL_WIDTH && pixels < SMALL) {
        gl_Position = pixel_corner(middle, corner);
        patch_irradiance = in_pixel;
    } else if (pixels < SMALL) // a sliver, of which few pixels would take much
        patch_irradiance = min(patch_irradiance, in_pixel / SMALL);
}
#endif
