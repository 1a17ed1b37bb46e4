// The ray from the camera through a pixel's middle, up to what it sees.
#include "lib/gbuffer.glsl"

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
