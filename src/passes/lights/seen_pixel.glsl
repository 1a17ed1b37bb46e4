// What the camera sees at pixels that are even over the picture: others with another shift.
#include "lib/gbuffer.glsl"

surface seen_place(vec2 place) {
    ivec2 size = gbuffer_size();
    return gbuffer_surface(min(ivec2(place * vec2(size)), size - 1));
}

surface seen_pixel(int i, vec2 shift) {
    return seen_place(fract((float(i) + 0.5) * vec2(0.7548776662, 0.5698402910) + shift));
}
