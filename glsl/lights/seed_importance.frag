#include "shared/bindings.h"

flat in float value;

layout(location = TARGET_RESULT) out float result;

void main() {
    result = value;
}
