#include "shared/bindings.h"

flat in vec2 pairs, hue;

layout(location = TARGET_RESULT) out vec4 sums;

void main() {
    sums = vec4(pairs, hue);
}
