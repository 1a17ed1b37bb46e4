/* Constants of reflection that C and GLSL share (reference/brdf.h). */
#ifndef SHARED_BRDF_H
#define SHARED_BRDF_H

/* Least roughness: smoother surfaces show point lights as points that no method finds. */
#define BRDF_LEAST_ROUGHNESS .045

/* Reflectance at normal incidence for an index of refraction of 1.5. */
#define BRDF_DIELECTRIC_F0 .04

/* Least n.v: for grazing views, and for views that a normal map turns away. */
#define BRDF_LEAST_COSINE .001

/* Default grazing reflectance over reflectance at normal incidence, at most 1 in all. Surfaces
 * below 2 % have no full grazing reflectance. */
#define BRDF_GRAZING_OF 50.0

/* Size of the table of the lobe's directional albedo (scene/lobe_albedo.h), and its first
 * coordinate. It is indexed by cube roots of alpha and of the cosine, up to 1. */
#define BRDF_ALBEDO_SIZE 32
#define BRDF_ALBEDO_FIRST .1

/* Least transmittance of an interface, to keep quotients finite. */
#define BRDF_LEAST_THROUGH .001

/* Fraction of uniform light that the specular part reflects, by roughness: for constant
 * reflectance, and for its increase at grazing angles. Fits of sums over the BRDF, within .005 and
 * .001. */
#define BRDF_MEAN_LOBE(r) (1.0 - (r) * (r) * ((r) * (2.176 - 1.29 * (r)) - 0.293))
#define BRDF_MEAN_GRAZING(r) (0.0476 / (1.0 + 12.58 * (r) * (r) * (r)))

#endif
