// Places on surfaces that rays end on, in the camera's picture.
#include "lib/camera.glsl"
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
