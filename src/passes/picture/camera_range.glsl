// What lies nearer or farther than the camera sees is cut away, where a pass asks for it (scene/camera_range.h).
#include "lib/gbuffer.glsl"

layout(location = LOCATION_CAMERA_RANGE) uniform vec2 camera_range; // metres

out float gl_ClipDistance[2];

void cut_by_range(vec4 clip) {
    float depth = camera.orthographic ? (1.0 - clip.z) * camera.far : clip.w;
    gl_ClipDistance[0] = depth - camera_range.x;
    gl_ClipDistance[1] = camera_range.y - depth;
}
