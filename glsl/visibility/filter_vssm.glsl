// Variance soft shadow maps [Dong 2011 ch. 7]: of what lies in a window mean and variance bound the part that is farther
// than the receiver, by Chebyshev's inequality. It says nothing where the mean is farther: windows fall into cells, those
// with a nearer mean are taken together, in the others a texel is compared.
#include "visibility/windows.glsl"

// Depths count from the receiver's own plane towards the light, so that one that is tilted does not shadow itself.
struct cells {
    float area;
    float pooled, above, above2, plane; // area of cells with a nearer mean; over it, sums of height, its square, the plane
    float compared, depth;              // blocked area of the others, and over it the sum of depths
};

const float VARIANCE_MIN = 1e-9; // a cell of less has one depth

cells cells_none() {
    return cells(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
}

void cells_add(inout cells c, cell k) {
    float above = k.plane - k.mean.x, variance = max(k.mean.y - k.mean.x * k.mean.x, 0.0);
    float stored = texelFetch(depth_maps, k.texel, 0).r;
    bool pooled = above > 0.0, compared = !pooled && variance > VARIANCE_MIN && stored < k.plane;
    float area = pooled ? k.area : 0.0;
    c.area += k.area;
    c.pooled += area;
    c.above += area * above;
    c.above2 += area * (variance + above * above);
    c.plane += area * k.plane;
    c.compared += compared ? k.area : 0.0;
    c.depth += compared ? k.area * stored : 0.0;
}

// What does not block is taken to lie in the receiver's plane (eq. 7.4): then the share of blockers is mean^2 / mean
// square of heights, theirs the mean square over the mean, and their sum that of all.
blocked cells_blocked(cells c) {
    float pooled = c.above * c.above / max(c.above2, 1e-30);
    float area = pooled + c.compared, depth = pooled * c.plane / max(c.pooled, 1e-30) - c.above + c.depth;
    return blocked(area / max(c.area, 1e-30), depth / max(area, 1e-30));
}

#include "visibility/filter_cells.glsl"
#include "visibility/filter_window.glsl"
