// A long caster on its way into a paraboloid depth map. The projection is stereographic: it makes each edge an arc of
// a circle, which a rasteriser cannot draw. So a polygon around the bent triangle is drawn, and paraboloid.frag
// leaves out what lies beyond its edges.
#include "passes/visibility/map_views.glsl"
#include "passes/visibility/paraboloid.glsl"
#include "shared/maps.h"

PASS_BLOCK(paraboloid_params, 16)

// An arc that strays from its chord by more than so many texels falls into pieces, no more than so many.
#define HULL_TEXELS 2.0
#define HULL_PIECES 4

layout(triangles) in;
layout(triangle_strip, max_vertices = 4 * (HULL_PIECES + 1)) out;

in vec3 corner[];
in int map[];
flat out vec2 range;
flat out vec3 plane;
flat out vec4 limits[3];
#ifdef MASKED
in vec2 corner_uv[];
flat out vec3 uv_slopes[2];
#endif

// What each vertex tells anew.
struct caster {
    vec2 range;
    vec3 plane;
    vec4 limits[3];
    vec3 uv_slopes[2];
    float least; // depth of the triangle's plane where it is nearest
};

// Neighbours overlap by so much, radians: no crack opens between them, or to what is drawn straight.
const float OVERLAP = 1e-4;

// The part above the map's plane: corners in a ring, and the edge that leaves each, by the normal of the plane that it
// spans with the centre, towards the inside; drawn straight where `arcs` is false.
vec3 ring[4], edges[4];
bool arcs[4];
int ring_size = 0;

// A polygon that holds its image.
vec2 hull[4 * (HULL_PIECES + 1)];
int hull_size = 0;

void hull_add(vec2 p) {
    hull[hull_size++] = p;
}

void ring_add(vec3 at, vec3 edge, bool arc) {
    ring[ring_size] = at;
    edges[ring_size] = edge;
    arcs[ring_size] = arc;
    ring_size++;
}

void ring_add_edge(vec3 a, vec3 b, vec3 edge, bool arc) {
    if (a.z > 0.0)
        ring_add(a, edge, arc);
    if ((a.z > 0.0) == (b.z > 0.0))
        return;
    vec3 c = mix(a, b, a.z / (a.z - b.z));
    if (a.z > 0.0)
        ring_add(c, vec3(0.0, 0.0, 1.0), true); // along the horizon
    else
        ring_add(c, edge, arc);
}

// What shorter triangles share is straight there, too.
bool is_arc(vec3 a, vec3 b) {
    return distance(a, b) > params.long_edge;
}

// dot(limit, vec4(direction, 1)) >= 0 inside. A plane cuts the sphere of directions: for an arc that of its edge and
// the centre, for a straight line one through the pole from which the sphere is projected.
vec4 limit_of(vec3 a, vec3 b, vec3 edge, bool arc, float turn) {
    const vec3 pole = vec3(0.0, 0.0, -1.0);
    vec3 normal = arc ? edge : turn * cross(normalize(a) - pole, normalize(b) - pole);
    return vec4(normal, (arc ? 0.0 : normal.z) + OVERLAP * length(normal));
}

// The circle of the edge is | p |^2 - 2 c.p - 1 = 0, c = edge.xy / edge.z. Where its tangents at a and b meet.
vec2 tangents_meet(vec3 edge, vec2 a, vec2 b) {
    vec2 middle = 0.5 * (a + b), outwards = middle * edge.z - edge.xy;
    return middle + outwards * (0.25 * edge.z * dot(a - b, a - b) / dot(outwards, outwards));
}

// Into how many pieces an arc falls, so that the hull holds little else than the triangle: by how far it strays from
// its chord, of a circle whose radius is length(edge) / | edge.z |.
int pieces_of(vec2 a, vec2 b, vec3 edge) {
    float strays = dot(a - b, a - b) * abs(edge.z) / (8.0 * length(edge));
    return int(clamp(ceil(sqrt(strays / (HULL_TEXELS * params.texel))), 1.0, float(HULL_PIECES)));
}

// An arc that bulges lies within tangents, another on this side of its chords.
void hull_add_edge(vec3 from, vec3 to, vec3 edge, bool arc) {
    vec2 a = paraboloid_project(from), end = paraboloid_project(to);
    int pieces = arc ? pieces_of(a, end, edge) : 1;
    bool bulges = arc && edge.z > 0.0;
    hull_add(a);
    for (int i = 1; i <= pieces; i++) {
        vec2 b = i < pieces ? paraboloid_project(normalize(mix(from, to, float(i) / float(pieces)))) : end;
        if (bulges)
            hull_add(tangents_meet(edge, a, b));
        else if (i < pieces)
            hull_add(b);
        a = b;
    }
}

void emit(vec2 p, caster of) {
    gl_Position = vec4(p, of.least, 1.0);
    gl_Layer = map[0];
    range = of.range;
    plane = of.plane;
    limits = of.limits;
#ifdef MASKED
    uv_slopes = of.uv_slopes;
#endif
    EmitVertex();
}

// From one side to the other and back, which covers all that it holds, convex or not.
void emit_hull(caster of) {
    for (int i = 0; i < hull_size; i++)
        emit(hull[(i & 1) == 1 ? (i + 1) / 2 : (hull_size - i / 2) % hull_size], of);
}

void main() {
    map_view v = map_view_at(map[0]);
    vec3 normal = cross(corner[1] - corner[0], corner[2] - corner[0]);
    float volume = dot(normal, corner[0]);
    // The surface that the centre itself lies on, or no farther off than what is left out as too near: seen edge-on, a
    // texel of it is many depths, and it would shadow itself.
    if (abs(volume) <= v.near * length(normal))
        return;
#ifdef SOLID
    if (volume > 0.0)
        return; // turned away from the centre
#endif
    caster drawn;
    drawn.range = vec2(v.near, 1.0 / v.z_far);
    drawn.plane = normal / volume;
    drawn.least = min(abs(volume) / length(normal) * (1.0 - LEAST_ROUNDING) * drawn.range.y, 1.0);
    drawn.uv_slopes[0] = drawn.uv_slopes[1] = vec3(0.0);
    for (int i = 0; i < 3; i++) {
        vec3 a = corner[i], b = corner[(i + 1) % 3], edge = cross(a, b) / volume;
        bool arc = is_arc(a, b);
        drawn.limits[i] = limit_of(a, b, edge, arc, sign(volume));
        ring_add_edge(a, b, edge, arc);
#ifdef MASKED
        drawn.uv_slopes[0] += corner_uv[(i + 2) % 3].x * edge;
        drawn.uv_slopes[1] += corner_uv[(i + 2) % 3].y * edge;
#endif
    }
    for (int i = 0; i < ring_size; i++)
        hull_add_edge(normalize(ring[i]), normalize(ring[(i + 1) % ring_size]), edges[i], arcs[i]);
    emit_hull(drawn);
}
