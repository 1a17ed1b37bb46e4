/* How a surface reflects: a Lambertian one, or glTF's metallic-roughness model [glTF 2.0, appendix B].
 *
 * f = albedo/pi T + nu D (f0 + (f90 - f0) w). D is the GGX distribution of normals, nu = G / (4 n.l n.v) the
 * height-correlated visibility of Smith, w = (1 - v.h)^5.
 *
 * The diffuse part has the light that the lobe leaves [Kulla and Conty 2017]: with E the
 * lobe's directional albedo (scene/lobe_albedo.h) and <E> its mean, it is base/pi (1 - E(v)) (1 - E(l)) / (1 - <E>).
 * glTF's mix, base/pi (1 - F(v.h)), makes up to 1.35 of the light of it: half vectors do not graze where v does. This
 * one is as reciprocal, and a white dielectric reflects all light, from and to everywhere. albedo is base (1 - E(v)), T
 * is (1 - E(l)) / (1 - <E>), 1 on average, so that irradiance times albedo is nearly the diffuse part's light.
 * Metals have no diffuse part, and lose the light that microfacets reflect twice: rough white ones .6 at most.
 *
 * All directions are unit and point away from the surface; v is where the light leaves to, l where it comes
 * from, n the shading normal. Grazing and hidden views, which normal maps make, are seen as
 * BRDF_LEAST_COSINE.
 */
#ifndef REFERENCE_BRDF_H
#define REFERENCE_BRDF_H

#include "base/unit.h"
#include "scene/material.h"

struct brdf {
    vec3s albedo; /* of the diffuse part, towards the view of brdf_turn; before it the mean */
    bool diffuse; /* that is all; the rest is 0 */
    float alpha;  /* roughness^2 */
    vec3s f0, f90;
    float outer_f0, outer_f90; /* reflectance of the interface over the diffuse part */
    float transmitted;         /* what it lets through, on average */
    vec3s below;               /* albedo of the diffuse part itself */
};

struct brdf_value {
    float diffuse;  /* T: times albedo / pi */
    vec3s specular; /* 1/sr */
};

/* A Lambertian surface of that albedo. */
struct brdf brdf_lambertian(vec3s albedo);

/* Of what the material says at one place. */
struct brdf brdf_of(const struct material *material, vec3s base_color,
                    const struct reflectance *reflectance);

/* Takes the albedo towards another view. */
void brdf_turn(struct brdf *brdf, vec3s n, vec3s v);

/* 0 below the horizon of n. */
struct brdf_value brdf_eval(const struct brdf *brdf, vec3s n, vec3s v, vec3s l);

/* A direction of light, which may come out below the horizon: by the cosine, or by the normals that v sees
 * [Heitz 2018], and with which density, 1/sr. sample: two numbers in [0, 1). */
vec3s brdf_sample(const struct brdf *brdf, vec3s n, vec3s v, vec2s sample);
float brdf_density(const struct brdf *brdf, vec3s n, vec3s v, vec3s l);

#endif
