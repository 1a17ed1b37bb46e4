// What is timed to choose how screen passes run (gl/screen_way.c): arithmetic, and a texel as wide as most passes store.
#include "shared/bindings.h"

layout(location = TARGET_RESULT) out vec4 result;

void main() {
    vec4 sum = vec4(gl_FragCoord.xy, 1.0, 1.0);
    for (int i = 0; i < 32; i++)
        sum = fract(sum.yzwx * 1.7 + float(i) * 0.3);
    result = sum;
}
