// A layer of the mean of several passes, from sums of layers that were weighted when they were added
// (passes/picture/layer.frag): as linear floats, or for a display.
#include "passes/picture/layer_shown.glsl"

layout(binding = UNIT_LAYER_SUMS) uniform sampler2D sums[LAYER_COUNT];

layout(location = TARGET_RESULT) out vec4 value;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 albedo = texelFetch(sums[LAYER_ALBEDO], pixel, 0);
    float coverage = albedo.a;
    vec3 weight = layer_weight(params.layer, params.weight, coverage, albedo.rgb);
    bool is_before = params.layer == LAYER_BEAUTY || params.layer == LAYER_AIRLIGHT || params.layer == LAYER_VOLUME;
    // A medium is seen before nothing.
    bool seen = coverage > 0.0 || is_before;
    if (params.layer == LAYER_BEAUTY)
        coverage = texelFetch(sums[LAYER_BEAUTY], pixel, 0).a; // of panes, too
    vec3 mean = seen ? texelFetch(sums[params.layer], pixel, 0).rgb / weight : vec3(0.0);
#ifdef DISPLAY
    value = display_before(params.layer, mean, coverage / params.weight);
#else
    value = vec4(mean, coverage / params.weight);
#endif
}
