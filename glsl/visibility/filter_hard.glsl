// A binary lookup in one texel.
#include "visibility/depth_maps.glsl"

float lit(int map, receiver r, float extent) {
    return texel_sees(map, r, ivec2(r.uv * lookup.map_size)) ? 1.0 : 0.0;
}
