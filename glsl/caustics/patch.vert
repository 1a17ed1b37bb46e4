// Triangle or splat of light that rays bring to a surface, as the camera sees it. What would be smaller than a pixel
// becomes one pixel that takes all of its flux.
#include "lib/camera.glsl"
#include "caustics/rays.glsl"

#ifdef SPLATS
layout(binding = UNIT_SPLATS) uniform sampler2D splats;
out vec2 splat_place;
#else
layout(binding = UNIT_PATCHES) uniform sampler2D patches[2];
#endif

flat out vec3 patch_irradiance, patch_normal, patch_middle;

const float SMALL = 0.05;     // pixels: of a patch that becomes one
const float SMALL_WIDTH = 4.0;

vec2 pixel_of(vec4 clip) {
    return (0.5 * clip.xy / clip.w + 0.5) * params.size;
}

vec4 clip_of(vec3 place) {
    return camera.world_to_clip * vec4(place, 1.0);
}

// Surface that a pixel shows of a plane there, m2.
float footprint(vec3 place, vec3 normal) {
    vec2 pixel = 2.0 * vec2(length(camera.right), length(camera.up)) / params.size;
    float ahead = dot(camera.forward, camera.forward);
    vec3 along = camera.orthographic ? camera.forward : place - camera.origin;
    float depth = camera.orthographic ? 1.0 : dot(along, camera.forward) / ahead;
    float facing = max(abs(dot(normal, along)), 1e-6 * length(along));
    return pixel.x * pixel.y * depth * depth * (dot(along, camera.forward) / sqrt(ahead)) / facing;
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
#ifdef SPLATS
    splat_place = vec2(0.0);
#endif
}

void set_surface(ivec2 texel, vec3 middle) {
    patch_normal = end_normal(texelFetch(ray_leaves, texel, 0));
    patch_middle = middle;
}

void main() {
    ivec2 texel = ray_texel(gl_VertexID / 6);
    int corner = gl_VertexID % 3;
    bool second = gl_VertexID % 6 >= 3;
    be_nowhere();
#ifdef SPLATS
    vec4 splat = texelFetch(splats, texel, 0);
    if (splat.w <= 0.0)
        return;
    vec3 middle = texelFetch(ray_ends, texel, 0).xyz;
    set_surface(texel, middle);
    vec4 clip = clip_of(middle);
    if (clip.w <= camera.near)
        return;
    float area = footprint(middle, patch_normal), pixels = splat.w / sqrt(area);
    if (pixels < 0.7) {
        if (!second)
            gl_Position = pixel_corner(middle, corner);
        patch_irradiance = splat.rgb / area;
        return;
    }
    vec3 right = normalize(abs(patch_normal.y) < 0.9 ? cross(patch_normal, vec3(0.0, 1.0, 0.0))
                                                     : cross(patch_normal, vec3(1.0, 0.0, 0.0)));
    vec2 first_corner = corner == 0 ? vec2(-1.0) : corner == 1 ? vec2(1.0, -1.0) : vec2(1.0);
    vec2 second_corner = corner == 0 ? vec2(-1.0) : corner == 1 ? vec2(1.0) : vec2(-1.0, 1.0);
    splat_place = second ? second_corner : first_corner;
    gl_Position = clip_of(middle + splat.w * (splat_place.x * right + splat_place.y * cross(patch_normal, right)));
    patch_irradiance = splat.rgb / (3.14159265 * splat.w * splat.w);
#else
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
    if (max(width.x, width.y) < SMALL_WIDTH && pixels < SMALL) {
        gl_Position = pixel_corner(middle, corner);
        patch_irradiance = flux.rgb / footprint(middle, patch_normal);
    }
#endif
}
