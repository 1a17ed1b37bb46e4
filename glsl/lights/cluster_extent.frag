#include "shared/bindings.h"

flat in vec4 place;

layout(location = TARGET_RESULT) out vec4 extremes; // max s, max t, -min s, -min t

void main() {
    extremes = place;
}
