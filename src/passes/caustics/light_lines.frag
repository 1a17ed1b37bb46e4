// What a medium scatters of a ray's light to the camera, before the surface that the pixel sees.
#include "lib/gbuffer.glsl"
#include "lib/medium.glsl"
#include "shared/caustics.h"

in vec3 line_place;
in float line_way;
flat in vec3 line_flux, line_direction;

layout(location = TARGET_RESULT) out vec4 scattered; // radiance

// What passes from a place on the line: beyond it by so many metres of the pixel's ray.
vec3 passes_from(float before_eye, float beyond) {
    return medium_passes(line_way + max(before_eye + beyond, 0.0));
}

#if PUBLISHED
// The line's light goes to the steps of the pixel's ray that a normalised Gaussian reaches [Dong 2011, fig. 8.4]. Its
// deviation is half its reach; ERF_2 is the share within it. All steps together take the line's light on average.
vec3 line_passes(float from_eye, float before_eye) {
    const float ERF_2 = 0.95449974, ROOT = 1.25331414;
    float scale = params.line_step / (params.line_reach * ROOT * ERF_2);
    int first = int(ceil((from_eye - params.line_reach) / params.line_step - 0.5));
    int last = int(floor((from_eye + params.line_reach) / params.line_step - 0.5));
    vec3 sum = vec3(0.0);
    for (int i = max(first, 0); i <= last; i++) {
        float beyond = (float(i) + 0.5) * params.line_step - from_eye, part = beyond / params.line_reach;
        sum += scale * exp(-2.0 * part * part) * passes_from(before_eye, beyond);
    }
    return sum;
}
#else
vec3 line_passes(float from_eye, float before_eye) {
    return passes_from(before_eye, 0.0);
}
#endif

void main() {
    bool seen = gl_FragCoord.z >= gbuffer_depth(ivec2(gl_FragCoord.xy));
    vec3 along = camera.orthographic ? camera.forward : line_place - camera.origin;
    float metres = length(along), cosine = -dot(along, line_direction) / metres;
    vec3 axis = view_axis(camera);
    float ahead = dot(along, axis) / (metres * length(axis));
    float from_eye = camera.orthographic ? dot(line_place - camera.origin, along) / metres : metres;
    vec2 part = medium_segment(line_place - from_eye / metres * along, along / metres, from_eye);
    float g = medium.g, sharp = 1.0 + g * g - 2.0 * g * cosine;
    float phase = (1.0 - g * g) / (4.0 * 3.14159265 * sharp * sqrt(sharp));
    vec3 passes = line_passes(from_eye, max(part.y - part.x, 0.0));
    scattered = vec4(seen ? medium.scattering * passes * line_flux * (phase / ahead) : vec3(0.0), 0.0);
}
