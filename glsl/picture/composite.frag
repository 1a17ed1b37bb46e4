// The picture for a display: exposure, tone map, sRGB.
#include "picture/display.glsl"
#include "picture/layer.glsl"

layout(location = TARGET_RESULT) out vec4 color;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    int shown = params.layer;
    seen s = seen_from(pixel);
    vec3 radiance = shown == LAYER_DIRECT     ? s.direct
                    : shown == LAYER_INDIRECT ? s.indirect
                                              : s.radiance;
    color = vec4(display(radiance, params.exposure, params.filmic), 1.0);
}
