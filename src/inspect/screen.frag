// Pictures in the window: left of the split one, right of it the other, or their difference. A picture of another size than
// its place is interpolated; one of the same size is copied bit by bit.
#include "shared/inspect.h"

PASS_BLOCK(screen_params, 32)

layout(binding = UNIT_LEFT_PICTURE) uniform sampler2D left_picture;
layout(binding = UNIT_RIGHT_PICTURE) uniform sampler2D right_picture;

layout(location = TARGET_RESULT) out vec4 color;

vec4 lookup(sampler2D picture, vec2 place) {
    ivec2 size = textureSize(picture, 0);
    vec2 at = place * vec2(size) - 0.5;
    ivec2 base = ivec2(floor(at)), last = size - 1;
    vec2 weight = at - vec2(base);
    vec4 low = mix(texelFetch(picture, clamp(base, ivec2(0), last), 0),
                   texelFetch(picture, clamp(base + ivec2(1, 0), ivec2(0), last), 0), weight.x);
    vec4 high = mix(texelFetch(picture, clamp(base + ivec2(0, 1), ivec2(0), last), 0),
                    texelFetch(picture, clamp(base + ivec2(1, 1), ivec2(0), last), 0), weight.x);
    return mix(low, high, weight.y);
}

vec4 show(sampler2D picture) {
    vec2 pixel = gl_FragCoord.xy - params.corner;
    ivec2 size = textureSize(picture, 0);
    if (size == ivec2(params.size))
        return texelFetch(picture, ivec2(pixel), 0);
    // Enlarged pixels are squares.
    if (params.size.x >= 2.0 * float(size.x))
        return texelFetch(picture, ivec2(pixel / params.size * vec2(size)), 0);
    return lookup(picture, pixel / params.size);
}

void main() {
    if (params.difference > 0.0) {
        color = vec4(4.0 * abs(show(left_picture).rgb - show(right_picture).rgb), 1.0);
        return;
    }
    float x = (gl_FragCoord.x - params.corner.x) / params.size.x;
    color = vec4((x < params.split ? show(left_picture) : show(right_picture)).rgb, 1.0);
}
