/* The colour by which a VAL is told from others. */
#ifndef SHARED_CLUSTER_COLOR_H
#define SHARED_CLUSTER_COLOR_H

#include "shared/types.h"

#ifndef GL_core_profile
#include <math.h>
#endif

/* Channel 0 to 2 of red, green, blue, for a display. Neighbours in number get hues far apart: steps of
 * the golden ratio. */
SHARED_FUNCTION float cluster_color(int k, int channel) {
    float turns = 0.1f + 0.61803399f * k;
    float hue = 6.0f * (turns - floor(turns)) + (channel == 0 ? 0.0f : channel == 1 ? 4.0f : 2.0f);
    float apart = hue < 6.0f ? hue - 3.0f : hue - 9.0f;
    float pure = (apart < 0.0f ? -apart : apart) - 1.0f;
    pure = pure < 0.0f ? 0.0f : pure < 1.0f ? pure : 1.0f;
    float pale = k % 2 == 0 ? 0.15f : 0.4f;
    return (pure + (1.0f - pure) * pale) * (k % 3 == 0 ? 0.8f : 1.0f);
}

#endif
