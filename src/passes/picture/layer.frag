// One layer as linear floats, for files and measurements, or weighted for a sum over passes. Normal and
// depth are the pixel's centre's.
#include "passes/picture/layer.glsl"

layout(location = TARGET_RESULT) out vec4 value;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    int shown = params.layer;
    float depth = gbuffer_depth(pixel);
    seen s = seen_from(pixel);
    value = vec4(0.0, 0.0, 0.0, shown == LAYER_BEAUTY ? s.opacity : s.coverage);
    if (shown == LAYER_BEAUTY)
        value.rgb = s.radiance;
    else if (shown == LAYER_DIRECT)
        value.rgb = s.direct;
    else if (shown == LAYER_INDIRECT)
        value.rgb = s.indirect;
    else if (shown == LAYER_ALBEDO)
        value.rgb = s.albedo;
    else if (shown == LAYER_AIRLIGHT)
        value.rgb = s.airlight;
    else if (shown == LAYER_CAUSTIC)
        value.rgb = s.caustic;
    else if (shown == LAYER_VOLUME)
        value.rgb = s.volume;
    else if (shown == LAYER_SPECULAR)
        value.rgb = s.direct_specular + s.indirect_specular;
    else if (shown == LAYER_DIRECT_SPECULAR)
        value.rgb = s.direct_specular;
    else if (shown == LAYER_INDIRECT_SPECULAR)
        value.rgb = s.indirect_specular;
#ifdef HAS_CAUSTICS
    else if (shown == LAYER_SENT)
        value = sent_by(pixel);
#endif
    else if (depth > 0.0)
        value.rgb = shown == LAYER_NORMAL
                        ? octahedral_decode(texelFetch(gbuffer_normals, ivec3(pixel, 0), 0).rg)
                        : vec3(view_linear_depth(camera, depth));
    if (params.weight > 0.0)
        value *= params.weight * vec4(layer_weight(shown, 1.0, s.coverage, s.albedo), 1.0);
}
