// A pixel of the camera's picture, as a point of the surface that it sees [Mavridis and Papaioannou 2011 section 3.2].
#include "lib/gbuffer.glsl"
#include "passes/volume/point_sums.glsl"

layout(binding = UNIT_GBUFFER_ALBEDO) uniform sampler2DArray gbuffer_albedos;

void main() {
    ivec2 size = gbuffer_size(), grid = min(size, ivec2(VOLUME_PIXELS));
    ivec2 place = ivec2(gl_VertexID % VOLUME_PIXELS, gl_VertexID / VOLUME_PIXELS);
    ivec2 pixel = ivec2((vec2(place) + 0.5) * vec2(size) / vec2(grid));
    surface s = gbuffer_surface(min(pixel, size - 1));
    surface_sum = radiosity_sum = back_sum = albedo_sum = vec4(0.0);
    is_turned = 0.0;
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    if (s.present && all(lessThan(place, grid)))
        point_add(s.position, s.normal, albedo_fetch(gbuffer_albedos, ivec3(pixel, 0)), false);
}
