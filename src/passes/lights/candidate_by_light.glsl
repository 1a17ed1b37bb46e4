// Candidates of the first round: as many of each light.
#ifdef SKY_RAYS
#include "passes/lights/sky_pieces.glsl"
#endif

float vpl_choose(vec3 point, out int index, out vec2 place) {
    float turn = point.z * float(light_count);
    index = min(int(turn), light_count - 1);
    place = point.xy;
#ifdef SKY_RAYS
    vec4 door = sky_door(index);
    place = fract(turn) < 0.5 ? door.xy + door.zw * place : place;
#endif
    return 1.0;
}
