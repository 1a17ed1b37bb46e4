// Whether what stands before the receiver in a cell lies beside all ways to the light: of what is behind it the map
// knows nothing. One depth in front and the receiver's own are told by two moments.
bool hides_nothing(receiver r, float extent, cell k, vec4 box) {
    float above = k.plane - k.mean.x, above2 = k.mean.y + k.plane * (k.plane - 2.0 * k.mean.x);
    vec4 ways = window(r, extent, max(k.plane - above2 / max(above, 1e-6), NEAREST * k.plane));
    return above > 0.0 && (any(lessThan(box.zw, ways.xy)) || any(greaterThan(box.xy, ways.zw)));
}

// The cells of a window, one after another, from a summed area table: each corner of the grid is fetched once.
cells window_cells(int map, receiver r, float extent, vec4 window, int parts, bool seeks, bool wanted) {
    vec2 high = min(window.zw * lookup.map_size, lookup.map_size - 0.01);
    vec2 low = min(window.xy * lookup.map_size, high - 1.0);
    cells c = cells_none();
    uvec4 below[PARTS_MAX + 3];
    vec2 before, edge;
    // As a count and not a branch: a software rasteriser leaves a loop that no pixel is in after one step.
    int corners = wanted ? parts + 3 : 0;
    edge.y = 0.0;
    for (int j = 0; j < corners; j++) {
        before.y = edge.y;
        edge.y = cell_edge(low.y, high.y, j, parts);
        uvec4 left = uvec4(0u), below_left = uvec4(0u);
        edge.x = 0.0;
        for (int i = 0; i < corners; i++) {
            before.x = edge.x;
            edge.x = cell_edge(low.x, high.x, i, parts);
            uvec4 corner = texelFetch(sums, ivec3(edge, map), 0), under = j > 0 ? below[i] : uvec4(0u);
            vec2 texels = edge - before;
            if (i > 0 && j > 0 && texels.x * texels.y > 0.0) {
                cell k;
                vec2 middle = 0.5 * (before + edge);
                k.area = cell_width(low.x, high.x, before.x, edge.x) * cell_width(low.y, high.y, before.y, edge.y);
                vec4 box = vec4(before, edge) / lookup.map_size;
                // A search rather finds the receiver itself, which the window that follows tells, than misses casters.
                k.plane = plane_nearest(r, seeks ? clamp(r.uv, box.xy, box.zw).xyxy : box);
                k.mean = vec4(corner - left - under + below_left) / (texels.x * texels.y * SUM_ONE);
                k.texel = ivec3(middle, map);
                if (!hides_nothing(r, extent, k, box))
                    cells_add(c, k);
            }
            below[i] = corner;
            left = corner;
            below_left = under;
        }
    }
    return c;
}
