#include "shared/bindings.h"

flat in vec2 distance_and_weight;

layout(location = TARGET_RESULT) out vec4 sum;

void main() {
    sum = vec4(distance_and_weight, 0.0, 0.0);
}
