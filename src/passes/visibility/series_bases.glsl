// Fourier bases of a texel's depth, four terms at a time [Dong 2011 §5.2, §5.3.1; erratum c_k = pi (2k-1)]: of the
// argument a that the map's range makes of it.
#include "passes/visibility/series.glsl"

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
