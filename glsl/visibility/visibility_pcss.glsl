// Percentage-closer soft shadows [Fernando 2005; Dong 2011 §2.4.2] in the paraboloid map: the mean depth of
// what blocks within the VAL's own angle, then the blocked share within the penumbra. It reads many texels
// where convolution reads a few filtered ones, but needs no bases, no MIP maps and no expansion of the
// depth range: the way to go where visibility is looked up seldom.

const float GOLDEN_ANGLE = 2.39996322972865;
// A cluster fills its bounding rectangle thinly towards the rim: over its side, the least error.
const float FILLED = 0.7;
const float ANGLE_MAX = 0.2; // radians: a wider filter leaves the plane that the receiver is taken for

// Tap i of n: a spiral of equal areas in the unit disk.
vec2 spiral(int i, int n) {
    float turn = float(i) * GOLDEN_ANGLE;
    return sqrt((float(i) + 0.5) / float(n)) * vec2(cos(turn), sin(turn));
}

float visibility(int map, vec3 position, vec3 normal) {
    map_view v = views[map];
    vec3 q = paraboloid_receiver(v, position, normal, lookup.bias, lookup.map_size);
    if (q.z <= 0.0)
        return 1.0;
    float r = length(q), extent = v.extent * FILLED, z_far = v.z_far;
    vec3 direction = q / r, local_normal = paraboloid_rotate(v, normal);
    vec2 p = paraboloid_project(direction), uv = p * 0.5 + 0.5;
    // An angle's half width in the map, by the Jacobian (1 + |p|^2) / 4.
    float half_width = 0.125 * (1.0 + dot(p, p)), texel = 0.5 / lookup.map_size;

    // The search: half of the VAL's width, as an angle from its centre to the receiver.
    float search = min(extent * sqrt(max(direction.z, 0.05)) / r, ANGLE_MAX);
    search = max(search * half_width, texel);
    float depth_sum = 0.0, blockers = 0.0;
    for (int i = 0; i < SEARCH_TAPS; i++) {
        vec2 at = uv + search * spiral(i, SEARCH_TAPS);
        if (!texel_sees(map, z_far, q, local_normal, at)) {
            depth_sum += texture(depth_maps, vec3(at, map)).r;
            blockers += 1.0;
        }
    }
    // The penumbra, seen from the centre [Dong 2009 §4.2]: p cos beta = (d - z) extent / z.
    float z = blockers > 0.0 ? max(depth_sum / blockers * z_far, 1e-3 * r) : r;
    float penumbra = max(r - z, 0.0) * extent / z;
    float width = max(min(penumbra / r, ANGLE_MAX) * half_width, texel);
    // As a count and not a branch: a software rasteriser leaves a loop that no pixel is in.
    int taps = blockers > 0.0 ? FILTER_TAPS : 0;
    float lit = 0.0;
    for (int i = 0; i < taps; i++)
        lit += texel_sees(map, z_far, q, local_normal, uv + width * spiral(i, FILTER_TAPS)) ? 1.0 : 0.0;
    return taps > 0 ? lit / float(FILTER_TAPS) : 1.0;
}
