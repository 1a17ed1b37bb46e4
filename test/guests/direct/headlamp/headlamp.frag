// One watt a square metre across the direction to the camera, over pi.
#include "lib/gbuffer.glsl"

layout(location = TARGET_RESULT) out vec4 direct;

void main() {
    surface s = gbuffer_surface(ivec2(gl_FragCoord.xy));
    float cosine = dot(s.normal, normalize(camera.origin - s.position));
    direct = vec4(s.present ? max(cosine, 0.0) / 3.14159265 : 0.0);
}
