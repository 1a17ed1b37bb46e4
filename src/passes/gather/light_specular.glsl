// What a surface that is not diffuse reflects of a VPL's light towards the eye, besides its diffuse part:
//     L = Phi / pi  f_r  cos_x  cos_i / (d^2 + r^2 / 2)
// A point's mirror image would be a spot in the picture: SPHERE spreads the light over the ball around the VPL that
// holds the patch that the pixel's VPLs stand for [Hašan et al. 2009]. The lobe is as much wider as the ball is.
// With RAYS a point gives no more than what rays do not find better (passes/gather/specular_rays.frag).
#include "passes/gather/specular_ways.glsl"
#include "lib/medium.glsl"
#include "passes/gather/vpl_terms.glsl"

// Of the pixel at hand.
specular_surface receiver_specular = specular_surface(vec3(0.0), vec3(0.0), 1.0, vec3(0.0), vec3(0.0));

vec3 specular_light(vpl light, surface s, float area) {
    vec3 to_vpl = light.position - s.position;
    float distance2 = dot(to_vpl, to_vpl);
    vec3 direction = to_vpl * inversesqrt(max(distance2, 1e-30));
    float cosine = -dot(light.normal, direction);
    if (cosine <= 0.0 || receiver_specular.f90 == vec3(0.0))
        return vec3(0.0);
    specular_surface seen = receiver_specular;
    if (SPECULAR == SPECULAR_RAYS) {
        ivec2 pixel;
        bool on_screen = camera_sees(light.position, light.normal, pixel);
        float rays = (on_screen ? float(params.specular_rays) : params.unseen_rays) * specular_effort(seen);
        specular_densities there = specular_densities_at(seen, direction, cosine, distance2, rays, area);
        float of_vpls = specular_weight(there.vpls, there.rays);
        return light.flux * specular_brdf(seen, direction) * (cosine / distance2 * of_vpls);
    }
    if (SPECULAR == SPECULAR_SPHERE) {
        // Half vectors turn by half of what directions do.
        float radius2 = params.sphere2 * area / distance2;
        seen.alpha = min(sqrt(seen.alpha * seen.alpha + 0.25 * radius2), 1.0);
    }
    return light.flux * specular_brdf(seen, direction) * (cosine / (distance2 + params.sphere2 * light.area * 0.5));
}

float given_back() {
    return 1.0;
}

int lights_per_test(int most) {
    return int(float(most) / specular_effort(receiver_specular));
}

bool receives_light(surface s, ivec2 pixel) {
    receiver_specular = gbuffer_specular(s, pixel);
    bool has_rays = SPECULAR == SPECULAR_RAYS && is_smooth(receiver_specular.alpha); // they find all
    return receiver_specular.f90 != vec3(0.0) && !has_rays;
}

// What is reflected of near VPLs counts as unoccluded.
vec3 unshadowed(int i, vpl light, surface s, out vec3 back) {
    vec3 to_light = light.position - s.position;
    vec3 reflected = is_behind_horizon(receiver_facet, to_light) ? vec3(0.0)
                                                                 : specular_light(light, s, light.area * weight);
    reflected *= medium_passes_between(s.position, light.position);
    back = -reflected * near_share(dot(to_light, to_light), light.area, light.reach);
    return reflected;
}

vec3 arriving(vec3 own, vec3 back, float visible) {
    return mix(-back, own, visible);
}
