// Triangle of light that rays bring to a surface, as the camera sees it. What would be much smaller than a pixel becomes
// one pixel that takes all of its flux.
#include "passes/caustics/place.glsl"

layout(binding = UNIT_PATCHES) uniform sampler2D patches[2];

const float SMALL = 0.25;      // pixels
const float SMALL_WIDTH = 4.0; // likewise

void main() {
    ivec2 texel = ray_texel(gl_VertexID / 6);
    int corner = gl_VertexID % 3;
    bool second = gl_VertexID % 6 >= 3;
    be_nowhere();
    vec4 flux = second ? texelFetch(patches[1], texel, 0) : texelFetch(patches[0], texel, 0);
    if (flux.w == 0.0)
        return;
    vec3 a = texelFetch(ray_ends, texel, 0).xyz, b = texelFetch(ray_ends, texel + ivec2(1), 0).xyz;
    vec3 c = texelFetch(ray_ends, texel + (second ? ivec2(0, 1) : ivec2(1, 0)), 0).xyz;
    vec4 clip_a = clip_of(a), clip_b = clip_of(b), clip_c = clip_of(c);
    vec3 middle = (a + b + c) / 3.0;
    set_surface(texel, middle);
    gl_Position = corner == 0 ? clip_a : corner == 1 ? clip_b : clip_c;
    patch_irradiance = flux.rgb / max(0.5 * length(cross(b - a, c - a)), 1e-30);
    if (min(clip_a.w, min(clip_b.w, clip_c.w)) <= camera.near)
        return;
    vec2 p = pixel_of(clip_a), q = pixel_of(clip_b), r = pixel_of(clip_c);
    vec2 width = max(p, max(q, r)) - min(p, min(q, r)), e = q - p, f = r - p;
    float pixels = 0.5 * abs(e.x * f.y - e.y * f.x);
    vec3 in_pixel = flux.rgb / footprint(middle, patch_normal);
    if (max(width.x, width.y) < SMALL_WIDTH && pixels < SMALL) {
        gl_Position = pixel_corner(middle, corner);
        patch_irradiance = in_pixel;
    } else if (pixels < SMALL) // a sliver, of which few pixels would take much
        patch_irradiance = min(patch_irradiance, in_pixel / SMALL);
}
