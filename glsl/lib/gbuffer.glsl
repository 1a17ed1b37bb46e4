// What each pixel of the camera's picture sees.
#include "lib/camera.glsl"
#include "lib/surface.glsl"

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
