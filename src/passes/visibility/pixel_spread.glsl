// A lobe narrower than the surface bends within a pixel would fall between the pixels' centres: up to 97 % of a smooth
// ball's highlight. It is made as wide as a pixel bends [Tokuyoshi and Kaplanyan 2019] and reflects as much light as before.
#include "lib/gbuffer_specular.glsl"
#include "lib/lobe_albedo.glsl"

const float MOST_SPREAD = 0.18; // of alpha^2, as in the paper

// The change of the normal from pixel to pixel along an axis, and its square. The side that differs less counts: across an
// edge lies another surface. The square is 1 where both sides are edges.
vec4 bend_along(vec3 normal, ivec2 pixel, ivec2 axis) {
    vec4 least = vec4(0.0, 0.0, 0.0, 1.0);
    for (int side = -1; side <= 1; side += 2) {
        ivec2 beside = pixel + side * axis, inside = clamp(beside, ivec2(0), gbuffer_size() - 1);
        surface other = gbuffer_surface(inside);
        vec3 apart = float(side) * (other.normal - normal);
        if (inside == beside && other.present && dot(apart, apart) < least.w)
            least = vec4(apart, dot(apart, apart));
    }
    return least;
}

// Grazing views bend much along one axis only, so they count by the root of the cosine: a lobe as wide as that would light
// too much with its tails.
float pixel_spread(specular_surface s, ivec2 pixel) {
    float both = bend_along(s.normal, pixel, ivec2(1, 0)).w + bend_along(s.normal, pixel, ivec2(0, 1)).w;
    return min(0.5 * both, MOST_SPREAD) * sqrt(dot(s.normal, s.to_eye));
}

// light_width: the light's own width as an angle, rad. An image wider than 1.4 pixels stays as it is.
specular_surface widened(specular_surface s, float light_width, ivec2 pixel) {
    specular_surface wide = s;
    float alpha2 = s.alpha * s.alpha, own = alpha2 + 0.1225 * light_width * light_width;
    float spread = s.f90.r > 0.0 && own < MOST_SPREAD ? pixel_spread(s, pixel) : 0.0;
    if (spread > own)
        wide.alpha = sqrt(alpha2 + spread - own);
    return wide;
}

// What the lobe reflects of even light over what the widened one does.
float widened_scale(specular_surface s, specular_surface wide) {
    float cosine = dot(s.normal, s.to_eye);
    return wide.alpha != s.alpha ? lobe_albedo(s.alpha, cosine).x / lobe_albedo(wide.alpha, cosine).x : 1.0;
}

// The lobe of a surface that bends more one way than the other, as a tube does, over the widened one, for light from a
// direction: it is wide along the bend alone.
float bent_lobe(specular_surface s, specular_surface wide, vec3 to_light, float light_width, ivec2 pixel) {
    if (wide.alpha == s.alpha || light_width > 0.5 * wide.alpha)
        return 1.0;
    vec4 x = bend_along(s.normal, pixel, ivec2(1, 0)), y = bend_along(s.normal, pixel, ivec2(0, 1));
    if (max(x.w, y.w) >= 1.0)
        return 1.0;
    float turn = 0.5 * atan(2.0 * dot(x.xyz, y.xyz), x.w - y.w);
    vec3 bend = cos(turn) * x.xyz + sin(turn) * y.xyz, h = normalize(s.to_eye + to_light), aside = cross(s.normal, h);
    float most = dot(bend, bend), cosine = sqrt(dot(s.normal, s.to_eye));
    vec2 spread = min(vec2(most, max(x.w + y.w - most, 0.0)), vec2(2.0 * MOST_SPREAD, MOST_SPREAD));
    vec2 alpha2 = max(vec2(s.alpha * s.alpha), cosine * spread - 0.1225 * light_width * light_width);
    float along = dot(h, normalize(bend - s.normal * dot(bend, s.normal))), n_h = dot(s.normal, h);
    float all = dot(aside, aside), across = max(all - along * along, 0.0), wide2 = wide.alpha * wide.alpha;
    float even = all / wide2 + n_h * n_h, bent = along * along / alpha2.x + across / alpha2.y + n_h * n_h;
    float over = wide2 * inversesqrt(alpha2.x * alpha2.y) * (even * even) / (bent * bent);
    return along * along > 3.0 * alpha2.x ? min(over, 1.0) : over;
}

// The part of a light from a direction that a surface reflects diffusely. Where it shines from below the horizon, at the
// horizon.
float diffuse_share(specular_surface seen, vec3 direction) {
    float f0 = max(seen.f0.r, max(seen.f0.g, seen.f0.b)), cosine = max(-dot(seen.normal, direction), BRDF_LEAST_COSINE);
    return let_through(f0, seen.f90.r, seen.alpha, cosine);
}
