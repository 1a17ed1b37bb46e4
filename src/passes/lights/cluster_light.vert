// Vertex j becomes the light of cluster j: RECTANGLES its rectangle, or else all that a VPL has. The rectangle's
// second moments in the plane across the mean normal are the cluster's: half sides of sqrt(3 lambda), which is
// exact for a rectangle that shines alike everywhere. A cluster of no VPLs is a light of no flux.
#include "lib/direction.glsl"
#include "shared/gather.h"
#if RECTANGLES
layout(xfb_buffer = 0, xfb_stride = 32) out;
layout(xfb_offset = 0) out vec4 captured_right;
layout(xfb_offset = 16) out vec4 captured_up;
#else
#include "lib/vpl_output.glsl"
#endif

layout(binding = UNIT_VAL_POSITION) uniform sampler2D light_positions; // w: count
layout(binding = UNIT_VAL_NORMAL) uniform sampler2D light_normals;
layout(binding = UNIT_VAL_FLUX) uniform sampler2D light_fluxes;
layout(binding = UNIT_SUM_SQUARES) uniform sampler2D sum_squares;
layout(binding = UNIT_SUM_PRODUCTS) uniform sampler2D sum_products;

// Half sides of the rectangle, along its axes.
void rectangle(mat3 moments, vec3 normal, out vec3 right, out vec3 up) {
    vec3 s = perpendicular(normal), t = cross(normal, s);
    float ss = dot(s, moments * s), tt = dot(t, moments * t), st = dot(s, moments * t);
    float mean = 0.5 * (ss + tt), apart = 0.5 * (ss - tt), half_span = length(vec2(apart, st));
    // A square's axes may be any.
    float turn = half_span > 1e-6 * mean ? 0.5 * atan(st, apart) : 0.0;
    right = (cos(turn) * s + sin(turn) * t) * sqrt(3.0 * (mean + half_span));
    up = (cos(turn) * t - sin(turn) * s) * sqrt(3.0 * max(mean - half_span, 0.0));
}

void main() {
    ivec2 j = ivec2(gl_VertexID, 0);
    vec4 position = texelFetch(light_positions, j, 0);
    vec3 normal = texelFetch(light_normals, j, 0).xyz, flux = texelFetch(light_fluxes, j, 0).rgb;
    vec4 squares = texelFetch(sum_squares, j, 0), products = texelFetch(sum_products, j, 0);
    float weight = max(dot(flux, vec3(1.0)), 1e-30);
    bool lit = position.w > 0.0;
    mat3 moments = mat3(squares.x, products.z, products.y, products.z, squares.y, products.x, products.y, products.x,
                        squares.z) / weight;
    vec3 right, up;
    rectangle(moments, normal, right, up);
#if RECTANGLES
    captured_right = vec4(lit ? right : vec3(0.0), 0.0);
    captured_up = vec4(lit ? up : vec3(0.0), 0.0);
#else
    float area = FORM == LIGHT_FORM_DISK ? squares.w : 4.0 * length(right) * length(up);
    // Near fields reach so far on average, squared, over the area.
    float reach = sqrt(products.w / (weight * max(area, 1e-30)));
    vpl_output(vpl_even(position.xyz, normal, lit ? area : 0.0, lit ? flux : vec3(0.0), lit ? reach : 0.0));
#endif
}
