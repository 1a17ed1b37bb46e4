// A point writes its value, or PAIR its two, which blending adds up or compares.
#include "shared/bindings.h"

flat in vec4 value;
layout(location = TARGET_RESULT) out vec4 result;
#ifdef PAIR
flat in vec4 second_value;
layout(location = TARGET_RESULT + 1) out vec4 second_result;
#endif

void main() {
    result = value;
#ifdef PAIR
    second_result = second_value;
#endif
}
