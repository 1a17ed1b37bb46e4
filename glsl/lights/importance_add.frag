#include "shared/bindings.h"

flat in float value;

layout(location = TARGET_RESULT) out vec2 value_and_count;

void main() {
    value_and_count = vec2(value, 1.0);
}
