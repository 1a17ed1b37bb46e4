// The picture for a display: exposure, tone map, sRGB.
#include "lib/layer.glsl"
#include "lib/display.glsl"

layout(location = TARGET_RESULT) out vec4 color;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    int shown = int(params.layer);
    seen s = seen_from(pixel);
    vec3 radiance = shown == LAYER_DIRECT     ? s.direct
                    : shown == LAYER_INDIRECT ? s.indirect
                                              : s.radiance;
    color = vec4(display(radiance, params.exposure, params.tone_map), 1.0);
}
