// What a surface gets from polygons that shine alike everywhere [Lambert 1760], clipped at its horizon.

// The share of an edge from a to b in Lambert's sum; the angle also where it is small.
float edge_share(vec3 a, vec3 b, vec3 normal) {
    vec3 across = cross(a, b);
    float sine = length(across);
    return sine > 0.0 ? atan(sine, dot(a, b)) * dot(normal, across) / sine : 0.0;
}

// The part of a polygon above the horizon, as its corners come, from the light's right to its up; they are
// relative to the receiver. Where the polygon goes below and comes back, the horizon closes it.
struct polygon_sum {
    float sum;
    vec3 leaves, enters; // on the horizon
};

// Cuts an edge at the horizon. False: all of it lies below.
bool polygon_cut(inout polygon_sum p, inout vec3 a, inout vec3 b, vec3 normal) {
    float above_a = dot(a, normal), above_b = dot(b, normal);
    if (above_a <= 0.0 && above_b <= 0.0)
        return false;
    vec3 crossing = mix(a, b, above_a / (above_a - above_b));
    if (above_a <= 0.0)
        a = p.enters = crossing;
    if (above_b <= 0.0)
        b = p.leaves = crossing;
    return true;
}

void polygon_edge(inout polygon_sum p, vec3 a, vec3 b, vec3 normal) {
    if (polygon_cut(p, a, b, normal))
        p.sum += edge_share(a, b, normal);
}

// Irradiance over radiance; 0 from behind.
float polygon_end(polygon_sum p, vec3 normal) {
    return max(0.5 * (p.sum + edge_share(p.leaves, p.enters, normal)), 0.0);
}

float rectangle_irradiance(vec3 center, vec3 right, vec3 up, vec3 normal) {
    polygon_sum p = polygon_sum(0.0, vec3(0.0), vec3(0.0));
    vec3 a = center - right - up, b = center + right - up, c = center + right + up, d = center - right + up;
    polygon_edge(p, a, b, normal);
    polygon_edge(p, b, c, normal);
    polygon_edge(p, c, d, normal);
    polygon_edge(p, d, a, normal);
    return polygon_end(p, normal);
}
