// Each pixel tests the visibility of each light.
#include "passes/gather/visibility_pixel.glsl"

vec3 light_of(surface s, ivec2 pixel, ivec2 lights) {
    return light_by_pixel(s, lights);
}
