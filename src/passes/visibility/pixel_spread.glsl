// A lobe narrower than the surface bends within a pixel would fall between the pixels' centres: up to 97 % of a smooth
// ball's highlight. It is made as wide as a pixel bends [Tokuyoshi and Kaplanyan 2019] and reflects as much light as before.
#include "lib/gbuffer_specular.glsl"
#include "lib/lobe_albedo.glsl"

const float MOST_SPREAD = 0.18; // of alpha^2, as in the paper

// To a pixel beside; 1 outside the picture, too.
float bend_towards(vec3 normal, ivec2 pixel) {
    ivec2 inside = clamp(pixel, ivec2(0), gbuffer_size() - 1);
    return inside == pixel ? surface_bend(normal, gbuffer_surface(inside)) : 1.0;
}

// Along each axis the side that differs less counts: across an edge lies another surface. Grazing views bend much along one
// axis only, so they count by the root of the cosine: a lobe as wide as that would light too much with its tails.
float pixel_spread(specular_surface s, ivec2 pixel) {
    float across = min(bend_towards(s.normal, pixel - ivec2(1, 0)), bend_towards(s.normal, pixel + ivec2(1, 0)));
    float along = min(bend_towards(s.normal, pixel - ivec2(0, 1)), bend_towards(s.normal, pixel + ivec2(0, 1)));
    return min(0.5 * (across + along), MOST_SPREAD) * sqrt(dot(s.normal, s.to_eye));
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
