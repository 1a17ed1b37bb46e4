// Depth as the argument of a map's Fourier series [Dong 2009 §4.1]. K terms tell apart what lies 1 / (2K) of the
// argument from each other, so that depth is fitted to the map's own casters: the nearest is at 0, the farthest at
// the end or, in an open map, two steps before it. Between them the argument climbs as
// x / (x + knee): light falls with the square of the distance, and where a near caster stands before a far wall,
// the near one's shadow counts.
#include "shared/maps.h"

// From here on, to either side of its middle, the truncated step is 0 or 1, within its ringing of a tenth.
const float SERIES_EDGE = 0.61 / (2.0 * float(BASIS_TERMS));
// The series has period 2: a step is as far from its neighbours, of the other sign. Where nothing is, it is here.
const float SERIES_END = 1.0 - 2.0 * SERIES_EDGE;

layout(std140, binding = BLOCK_SERIES_RANGES) uniform series_range_uniforms {
    vec4 series_range_rows[SERIES_RANGES_MAX];
};

series_range series_range_at(int map) {
    vec4 row = series_range_rows[map];
    return series_range(row.x, row.y, row.z, row.w);
}

// z: map depth.
float series_argument(series_range range, float z) {
    float beyond = max(z - range.nearest, 0.0);
    return range.scale * beyond / (beyond + range.knee);
}

// And back.
float series_depth(series_range range, float argument) {
    return range.nearest + range.knee * argument / max(range.scale - argument, 1e-6);
}

// A receiver before all casters is as good as on the nearest, one behind all as good as a step behind the farthest.
float series_receiver(series_range range, float d, float shift) {
    float farthest = series_argument(range, range.farthest);
    return clamp(series_argument(range, d) - shift, -SERIES_EDGE, farthest + SERIES_EDGE);
}
