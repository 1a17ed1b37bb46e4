// What depths the casters of map gl_WorkGroupID.x take: an invocation reads a column of texels, or several.
#include "passes/visibility/series.glsl"

#define COLUMNS 256

const float DISC = 0.785398; // of a square

layout(local_size_x = COLUMNS) in;
layout(binding = UNIT_MAP_DEPTH) uniform sampler2DArray depths;
layout(std430, binding = STORAGE_SERIES_RANGES) writeonly buffer series_range_storage {
    series_range ranges[];
};

// The nearest, the farthest, their sum, their count.
shared vec4 found[COLUMNS];

vec4 join(vec4 a, vec4 b) {
    return vec4(min(a.x, b.x), max(a.y, b.y), a.zw + b.zw);
}

vec4 read_columns(int map, int first) {
    ivec2 size = textureSize(depths, 0).xy;
    vec4 all = vec4(1.0, 0.0, 0.0, 0.0);
    for (int x = first; x < size.x; x += COLUMNS)
        for (int y = 0; y < size.y; y++) {
            float z = texelFetch(depths, ivec3(x, y, map), 0).r;
            if (z < 1.0)
                all = join(all, vec4(z, z, z, 1.0));
        }
    return all;
}

// Casters that are all as far have a range too. With the knee at their mean depth walls that lie far off leak more
// than near things gain, with one much farther off there is hardly a knee. A map that sees less than half of its
// half space is open: a floor that is too near to its centre is not in it, but may be lit beyond all casters.
series_range fit(vec4 all, float texels) {
    float farthest = all.w > 0.0 ? all.y : 1.0, nearest = min(all.x, 0.5 * farthest);
    float mean = all.w > 0.0 ? all.z / all.w : farthest, knee = 2.0 * (mean - nearest);
    bool open = all.w < 0.5 * DISC * texels;
    float end = open ? SERIES_END - 2.0 * SERIES_EDGE : SERIES_END;
    return series_range(nearest, farthest, knee, end * (1.0 + knee / (farthest - nearest)));
}

void main() {
    int map = int(gl_WorkGroupID.x), own = int(gl_LocalInvocationID.x);
    found[own] = read_columns(map, own);
    for (int others = COLUMNS / 2; others > 0; others /= 2) {
        barrier();
        if (own < others)
            found[own] = join(found[own], found[own + others]);
    }
    if (own == 0)
        ranges[map] = fit(found[0], float(textureSize(depths, 0).x * textureSize(depths, 0).y));
}
