#include "shared/bindings.h"

flat in vec2 pairs;

layout(location = TARGET_RESULT) out vec4 spread;

void main() {
    spread = vec4(pairs, 0.0, 0.0);
}
