// What a medium scatters of a ray's light to the camera, before the surface that the pixel sees.
#include "lib/gbuffer.glsl"
#include "lib/medium.glsl"

in vec3 line_place;
in float line_way;
flat in vec3 line_flux, line_direction;

layout(location = TARGET_RESULT) out vec4 scattered; // radiance

void main() {
    bool seen = gl_FragCoord.z >= gbuffer_depth(ivec2(gl_FragCoord.xy));
    vec3 along = camera.orthographic ? camera.forward : line_place - camera.origin;
    float metres = length(along), cosine = -dot(along, line_direction) / metres;
    float ahead = dot(along, camera.forward) / (metres * length(camera.forward));
    float from_eye = camera.orthographic ? dot(line_place - camera.origin, along) / metres : metres;
    vec2 part = medium_segment(line_place - from_eye / metres * along, along / metres, from_eye);
    float g = medium.g, sharp = 1.0 + g * g - 2.0 * g * cosine;
    float phase = (1.0 - g * g) / (4.0 * 3.14159265 * sharp * sqrt(sharp));
    vec3 passes = medium_passes(line_way + max(part.y - part.x, 0.0));
    scattered = vec4(seen ? medium.scattering * passes * line_flux * (phase / ahead) : vec3(0.0), 0.0);
}
