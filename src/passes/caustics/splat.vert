// Round spot of a ray's light on a surface, as a triangle around it. A spot smaller than a pixel becomes one pixel that takes
// all of its flux.
#include "passes/caustics/place.glsl"

layout(binding = UNIT_SPLATS) uniform sampler2D splats;

flat out float splat_radius; // metres; 0: one pixel

const float SMALL = 0.7; // pixels

void main() {
    ivec2 texel = ray_texel(gl_VertexID / 3);
    int corner = gl_VertexID % 3;
    be_nowhere();
    splat_radius = 0.0;
    vec4 splat = texelFetch(splats, texel, 0);
    if (splat.w <= 0.0)
        return;
    vec3 middle = texelFetch(ray_ends, texel, 0).xyz;
    if (clip_of(middle).w <= camera.near)
        return;
    set_surface(texel, middle);
    float area = footprint(middle, patch_normal);
    if (splat.w < SMALL * sqrt(area)) {
        gl_Position = pixel_corner(middle, corner);
        patch_irradiance = splat.rgb / area;
        return;
    }
    splat_radius = splat.w;
    vec3 right = normalize(abs(patch_normal.y) < 0.9 ? cross(patch_normal, vec3(0.0, 1.0, 0.0))
                                                     : cross(patch_normal, vec3(1.0, 0.0, 0.0)));
    vec2 aside = corner == 0 ? vec2(0.0, 2.0) : vec2(corner == 1 ? -1.7320509 : 1.7320509, -1.0);
    gl_Position = clip_of(middle + splat.w * (aside.x * right + aside.y * cross(patch_normal, right)));
    patch_irradiance = splat.rgb / (3.14159265 * splat.w * splat.w);
}
