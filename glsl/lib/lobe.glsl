// Light of areas by linearly transformed cosines [Heitz et al. 2016]: a space in which the specular part's lobe is a
// cosine, so that polygons light it as they light what is diffuse.
#include "lib/brdf.glsl"
#include "lib/lobe_albedo.glsl"
#include "lib/direction.glsl"

layout(binding = UNIT_LOBES) uniform sampler2D lobes; // scene/gpu/lobes.h

struct lobe {
    mat3 from_world;
    vec3 horizon; // the surface's normal there: unit, across its horizon
    vec3 albedo;
    float alpha; // the narrower, the larger things are there
};

lobe lobe_of(specular_surface s) {
    float cosine = dot(s.normal, s.to_eye), size = float(textureSize(lobes, 0).x);
    vec2 place = vec2(sqrt(max(1.0 - cosine, 0.0)), sqrt(s.alpha));
    place = (place * (size - 1.0) + 0.5) / size;
    vec4 rows = textureLod(lobes, place, 0.0);
    vec3 aside = s.to_eye - s.normal * cosine;
    vec3 right = dot(aside, aside) > 1e-12 ? normalize(aside) : perpendicular(s.normal);
    mat3 turned = mat3(rows.x * right + rows.y * s.normal, cross(s.normal, right),
                       s.alpha * (rows.z * right + rows.w * s.normal));
    vec2 horizon = vec2(-s.alpha * rows.z, rows.x) * inversesqrt(rows.x * rows.x + s.alpha * s.alpha * rows.z * rows.z + 1e-30);
    vec3 albedo = specular_albedo(s.f0, s.f90, s.alpha, cosine);
    // The reflecting lobe ends at the horizon, the cosine's image does not: what it has above stands for all.
    return lobe(transpose(turned), vec3(horizon.x, 0.0, horizon.y), albedo / (0.5 + 0.5 * horizon.y), s.alpha);
}
