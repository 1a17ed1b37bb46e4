// One layer as linear floats, for files and measurements.
#include "lib/layer.glsl"

layout(location = 0) out vec4 value;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    int shown = int(params.layer);
    float depth = texelFetch(depths, ivec3(pixel, 0), 0).r;
    bool present = depth > 0.0;
    value = vec4(0.0, 0.0, 0.0, present ? 1.0 : 0.0);
    if (!present)
        return;
    if (shown == LAYER_BEAUTY)
        value.rgb = beauty_layer(pixel);
    else if (shown == LAYER_DIRECT)
        value.rgb = direct_layer(pixel);
    else if (shown == LAYER_INDIRECT)
        value.rgb = indirect_layer(pixel);
    else if (shown == LAYER_ALBEDO)
        value.rgb = albedo_fetch(albedos, ivec3(pixel, 0));
    else if (shown == LAYER_NORMAL)
        value.rgb = octahedral_decode(texelFetch(normals, ivec3(pixel, 0), 0).rg);
    else
        value.rgb = vec3(view_linear_depth(camera, depth));
}
