// What patches keep of all paths' light.
#include "shared/bounce.h"

layout(binding = UNIT_PATH_AREAS) uniform sampler2D path_areas; // and powers

layout(location = TARGET_RESULT) out vec4 kept;

void main() {
    vec2 powers = vec2(0.0);
    for (int i = 0; i < params.paths; i++)
        powers += texelFetch(path_areas, ivec2(i, 0), 0).yz;
    kept = vec4(powers.x > 0.0 ? powers.x / powers.y : 1.0);
}
