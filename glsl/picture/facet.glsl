// A triangle as rays meet it: it receives by the shading normal, but how large it is, to the light and to what it lights,
// is by its own. Along light paths the two trade places [Veach 1997, §5.3].
// At a facet's horizon the cosines grow apart without a bound.
const float ALBEDO_MOST = 8.0;

// Takes the triangle's own normal in place of the shading normal; returns what it receives by that, over what meets its
// plane: cos_s / cos_g.
float facet_share(inout vec3 normal) {
    vec3 facet = cross(dFdx(surface_position), dFdy(surface_position));
    float shading = dot(normal, surface_to_other), geometric = dot(facet, surface_to_other);
    if (geometric == 0.0)
        return 1.0;
    normal = facet * (inversesqrt(dot(facet, facet)) * sign(geometric));
    return clamp(shading / dot(normal, surface_to_other), 0.0, ALBEDO_MOST);
}

vec3 sent_by_facet(vec3 color, inout vec3 normal) {
    return clamp(color, 0.0, 1.0) * facet_share(normal);
}
