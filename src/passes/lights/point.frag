// A point writes its value, which blending adds up or compares.
#include "shared/bindings.h"

flat in vec4 value;

layout(location = TARGET_RESULT) out vec4 result;

void main() {
    result = value;
}
