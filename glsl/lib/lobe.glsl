// Light of areas by linearly transformed cosines [Heitz et al. 2016]: a space in which the specular part's lobe is a
// cosine, so that polygons light it as they light what is diffuse.
#include "lib/brdf.glsl"
#include "lib/tangent.glsl"

layout(binding = UNIT_LOBES) uniform sampler2DArray lobes; // scene/gpu/lobes.h

struct lobe {
    mat3 from_world;
    vec3 albedo;
    float alpha; // the narrower, the larger things are there
};

lobe lobe_of(specular_surface s) {
    float cosine = dot(s.normal, s.to_eye), size = float(textureSize(lobes, 0).x);
    vec2 place = vec2(sqrt(max(1.0 - cosine, 0.0)), sqrt(s.alpha));
    place = (place * (size - 1.0) + 0.5) / size;
    vec4 rows = textureLod(lobes, vec3(place, 0.0), 0.0);
    vec2 share = textureLod(lobes, vec3(place, 1.0), 0.0).xy;
    vec3 aside = s.to_eye - s.normal * cosine;
    vec3 right = dot(aside, aside) > 1e-12 ? normalize(aside) : perpendicular(s.normal);
    mat3 turned = mat3(rows.x * right + rows.y * s.normal, cross(s.normal, right),
                       s.alpha * (rows.z * right + rows.w * s.normal));
    return lobe(transpose(turned), s.f0 * share.x + (s.f90 - s.f0) * share.y, s.alpha);
}
