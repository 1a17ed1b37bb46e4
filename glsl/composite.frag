// The picture for a display: exposure, tone map, sRGB.
#include "lib/layer.glsl"
#include "lib/srgb.glsl"

layout(location = 0) out vec4 color;

// The usual fit to the ACES filmic curve [Narkowicz 2015].
vec3 filmic(vec3 x) {
    return x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    int shown = int(params.layer);
    vec3 radiance = shown == LAYER_DIRECT     ? direct_layer(pixel)
                    : shown == LAYER_INDIRECT ? indirect_layer(pixel)
                                              : beauty_layer(pixel);
    vec3 exposed = radiance * params.exposure;
    if (params.tone_map > 0.5)
        exposed = filmic(exposed);
    color = vec4(srgb_encode(clamp(exposed, 0.0, 1.0)), 1.0);
}
