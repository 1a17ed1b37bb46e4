/* Reflection: Lambertian, or glTF's metallic-roughness model [glTF 2.0, appendix B].
 *
 * f = albedo/pi T + nu D (f0 + (f90 - f0) w). D is the GGX distribution, nu = G / (4 n.l n.v) the
 * height-correlated Smith visibility, w = (1 - v.h)^5. The diffuse part has the light that the lobe
 * leaves [Kulla and Conty 2017]: base/pi (1 - E(v)) (1 - E(l)) / (1 - <E>). E is the lobe's
 * directional albedo (scene/lobe_albedo.h), <E> its mean. It deviates from glTF's mix,
 * base/pi (1 - F(v.h)), which has up to 1.35 of its light. It is reciprocal, and a white dielectric
 * reflects all light. albedo is base (1 - E(v)); T is (1 - E(l)) / (1 - <E>), 1 on average. Metals
 * have no diffuse part and lose multiple scattering, at most .6. Directions are unit and point away
 * from the surface: v to the viewer, l to the light; n is the shading normal. Grazing and hidden
 * views count as BRDF_LEAST_COSINE. */
#ifndef REFERENCE_BRDF_H
#define REFERENCE_BRDF_H

#include "base/unit.h"
#include "scene/material.h"

struct brdf {
    vec3s albedo; /* albedo of the diffuse part for the view of brdf_turn; initially the mean */
    bool diffuse; /* Lambertian; all other members are 0 */
    float alpha;  /* roughness^2 */
    vec3s f0, f90;
    float outer_f0, outer_f90; /* reflectance of the interface over the diffuse part */
    float transmitted;         /* mean transmittance of the interface */
    vec3s below;               /* albedo of the diffuse part under the interface */
};

struct brdf_value {
    float diffuse;  /* T, a factor of albedo / pi */
    vec3s specular; /* 1/sr */
};

/* Returns a Lambertian surface. */
struct brdf brdf_lambertian(vec3s albedo);

/* Returns the reflection of the material at one point. */
struct brdf brdf_of(const struct material *material, vec3s base_color,
                    const struct reflectance *reflectance);

/* Sets the albedo for another view. */
void brdf_turn(struct brdf *brdf, vec3s n, vec3s v);

/* Returns the reflection; 0 below the horizon of n. */
struct brdf_value brdf_eval(const struct brdf *brdf, vec3s n, vec3s v, vec3s l);

/* brdf_sample returns a direction of light, by the cosine or by visible normals [Heitz 2018]. It
 * may be below the horizon. sample: two numbers in [0, 1). brdf_density returns its density,
 * 1/sr. */
vec3s brdf_sample(const struct brdf *brdf, vec3s n, vec3s v, vec2s sample);
float brdf_density(const struct brdf *brdf, vec3s n, vec3s v, vec3s l);

#endif
