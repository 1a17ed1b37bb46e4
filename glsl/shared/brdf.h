/* What C and GLSL must agree on about surfaces' reflection: reference/brdf.h. */
#ifndef SHARED_BRDF_H
#define SHARED_BRDF_H

/* Smoother surfaces show lights without a size as points that no method here finds. */
#define BRDF_LEAST_ROUGHNESS .045

/* Reflectance from straight on of an index of refraction of 1.5. */
#define BRDF_DIELECTRIC_F0 .04

/* n.v of views that graze more, or that a normal map turns away. */
#define BRDF_LEAST_COSINE .001

/* What reflects less than 2 % from straight on has no full grazing reflectance either, where nothing else
 * is known of it: that over the reflectance from straight on, at most 1. */
#define BRDF_GRAZING_OF 50.0

/* The table of the lobe's directional albedo (scene/lobe_albedo.h) goes by cube roots of alpha and of the cosine, from
 * this one to 1 in so many steps. */
#define BRDF_ALBEDO_SIZE 32
#define BRDF_ALBEDO_FIRST .1

/* The least share of light that counts as let through by an interface: keeps quotients finite. */
#define BRDF_LEAST_THROUGH .001

/* What the specular part reflects of light that comes evenly, by its roughness: of a reflectance that is the same from
 * everywhere, and of what it is more when grazing. Fits of sums over the BRDF: within .005 and .001. */
#define BRDF_MEAN_LOBE(r) (1.0 - (r) * (r) * ((r) * (2.176 - 1.29 * (r)) - 0.293))
#define BRDF_MEAN_GRAZING(r) (0.0476 / (1.0 + 12.58 * (r) * (r) * (r)))

#endif
