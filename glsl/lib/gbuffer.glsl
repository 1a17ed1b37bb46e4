// The camera's view: what each pixel of its picture sees, and the ray to it.
#include "lib/view.glsl"

layout(std140, binding = BLOCK_VIEW) uniform view_uniforms {
    view camera;
};

layout(binding = UNIT_GBUFFER_DEPTH) uniform sampler2DArray gbuffer_depths;
layout(binding = UNIT_GBUFFER_NORMAL) uniform sampler2DArray gbuffer_normals;

ivec2 gbuffer_size() {
    return textureSize(gbuffer_depths, 0).xy;
}

// Reversed; 0 where nothing is.
float gbuffer_depth(ivec2 pixel) {
    return texelFetch(gbuffer_depths, ivec3(pixel, 0), 0).r;
}

surface gbuffer_surface(ivec2 pixel) {
    return surface_fetch(camera, gbuffer_depths, gbuffer_normals, ivec3(pixel, 0));
}

// What the camera sees at pixels that are even over the picture: others with another shift.
surface seen_place(vec2 place) {
    ivec2 size = gbuffer_size();
    return gbuffer_surface(min(ivec2(place * vec2(size)), size - 1));
}

surface seen_pixel(int i, vec2 shift) {
    return seen_place(fract((float(i) + 0.5) * vec2(0.7548776662, 0.5698402910) + shift));
}

// The ray from the camera through a pixel's middle, up to what it sees.
struct sight {
    vec3 origin, direction; // unit
    float ray_length;       // metres; where nothing is seen without end
};

sight sight_of(ivec2 pixel) {
    vec2 ndc = (vec2(pixel) + 0.5) / vec2(gbuffer_size()) * 2.0 - 1.0;
    float depth = gbuffer_depth(pixel);
    vec3 origin = view_position_at(camera, ndc, 0.0);
    vec3 along = view_position_at(camera, ndc, 1.0) - origin;
    float per_depth = length(along);
    return sight(origin, along / per_depth, depth > 0.0 ? per_depth * view_linear_depth(camera, depth) : 1e30);
}
