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

// Fourier bases of a texel's depth, four terms at a time [Dong 2011 §5.2, §5.3.1; erratum c_k = pi (2k-1)]: of the
// argument a that the map's range makes of it.
struct series_bases {
    vec4 cosines, sines; // of c_k a
    float a;             // times these the bases of depth
};

series_bases series_bases_of(int map, float z, int first_term) {
    const float PI = 3.14159265358979;
    float a = z < 1.0 ? series_argument(series_range_at(map), z) : SERIES_END;
    // c_k = pi (2k - 1) climbs by 2 pi: one sine and cosine, then turns by 2 pi a.
    float first = PI * float(2 * first_term + 1) * a, turn = 2.0 * PI * a;
    vec2 angle = vec2(cos(first), sin(first)), rotation = vec2(cos(turn), sin(turn));
    series_bases b;
    b.a = a;
    for (int k = 0; k < 4; k++) {
        b.cosines[k] = angle.x;
        b.sines[k] = angle.y;
        angle = vec2(angle.x * rotation.x - angle.y * rotation.y,
                     angle.x * rotation.y + angle.y * rotation.x);
    }
    return b;
}
