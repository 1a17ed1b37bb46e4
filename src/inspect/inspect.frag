// A buffer of the frame as colours.
#include "lib/gbuffer.glsl"
#include "inspect/inspect.glsl"
#include "lib/light.glsl"
#include "passes/picture/display.glsl"

layout(binding = UNIT_INSPECTED_LAYERS) uniform sampler2DArray layers;
layout(binding = UNIT_INSPECTED_PLANE) uniform sampler2D plane;

layout(location = TARGET_RESULT) out vec4 color;

// Near is bright, from the front to the back of the scene's bounding sphere.
vec3 show_depth(view v, float depth) {
    float middle = distance(v.origin, params.center);
    float low = max(0.0, middle - params.radius), high = middle + params.radius;
    float t = clamp((view_linear_depth(v, depth) - low) / (high - low), 0.0, 1.0);
    return depth > 0.0 ? vec3(mix(0.95, 0.1, t)) : NOTHING;
}

// A paraboloid map fills the disc of its square.
bool in_map(vec2 place) {
    vec2 p = place * 2.0 - 1.0;
    return dot(p, p) <= 1.0;
}

vec3 show_layers(inspected at) {
    ivec3 size = textureSize(layers, 0);
    ivec3 texel = ivec3(min(ivec2(at.place * vec2(size.xy)), size.xy - 1), at.layer);
    vec4 value = texelFetch(layers, texel, 0);
    switch (params.kind) {
    case INSPECT_NORMAL:
        return texelFetch(gbuffer_depths, texel, 0).r > 0.0 ? octahedral_decode(value.rg) * 0.5 + 0.5 : NOTHING;
    case INSPECT_ALBEDO:
        return srgb_encode(value.rgb * value.rgb);
    case INSPECT_DEPTH:
        return show_depth(camera, value.r);
    case INSPECT_SINGLE_DEPTH:
        return show_depth(light_view_at(at.layer).view, value.r);
    case INSPECT_FACE_DEPTH:
        return show_depth(light_view_at(single_view_count + at.layer).view, value.r);
    case INSPECT_MAP_DEPTH:
        return in_map(at.place) ? vec3(1.0 - 0.9 * value.r) : NOTHING;
    case INSPECT_BASIS:
        return in_map(at.place) ? value.rgb : NOTHING;
    default:
        return in_map(at.place) ? value.rgb * 0.5 + 0.5 : NOTHING;
    }
}

vec3 show_plane(inspected at) {
    ivec2 size = textureSize(plane, 0);
    vec3 value = texelFetch(plane, min(ivec2(at.place * vec2(size)), size - 1), 0).rgb;
    if (params.kind == INSPECT_IRRADIANCE)
        return srgb_encode(clamp(value * params.exposure, 0.0, 1.0));
    // The scene as a ground for marks.
    return vec3(dot(value, vec3(0.2126, 0.7152, 0.0722)) * 0.4 + 0.03);
}

void main() {
    vec2 picture = vec2(textureSize(plane, 0));
    bool is_plane = params.kind >= INSPECT_IRRADIANCE;
    inspected at = inspect_place(is_plane ? picture : vec2(textureSize(layers, 0).xy));
    color = vec4(NOTHING, 1.0);
    if (at.present)
        color.rgb = is_plane ? show_plane(at) : show_layers(at);
}
