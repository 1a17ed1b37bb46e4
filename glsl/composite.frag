// The picture for a display: exposure, tone map, sRGB.
#include "lib/layer.glsl"
#include "lib/display.glsl"

layout(location = 0) out vec4 color;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    int shown = int(params.layer);
    vec3 radiance = shown == LAYER_DIRECT     ? direct_layer(pixel)
                    : shown == LAYER_INDIRECT ? indirect_layer(pixel)
                                              : beauty_layer(pixel);
    color = vec4(display(radiance, params.exposure, params.tone_map), 1.0);
}
