// The layers of a picture, from the buffers of the frame.
#include "lib/surface.glsl"
#include "shared/params.h"

layout(std140, binding = BLOCK_VIEW) uniform view_uniforms {
    view camera;
};
layout(std140, binding = BLOCK_PASS) uniform pass_uniforms {
    composite_params params;
};
layout(binding = 0) uniform sampler2DArray depths;
layout(binding = 1) uniform sampler2DArray normals;
layout(binding = 2) uniform sampler2DArray albedos;
layout(binding = 3) uniform sampler2D directs;
layout(binding = 4) uniform sampler2D indirects;

// Irradiance over pi: the radiance of a white surface.
vec3 direct_layer(ivec2 pixel) {
    return params.light.rgb * texelFetch(directs, pixel, 0).r;
}

vec3 indirect_layer(ivec2 pixel) {
    return params.indirect * texelFetch(indirects, pixel, 0).rgb;
}

// L = albedo (direct + indirect), linear radiance.
vec3 beauty_layer(ivec2 pixel) {
    return albedo_fetch(albedos, ivec3(pixel, 0)) * (direct_layer(pixel) + indirect_layer(pixel));
}
