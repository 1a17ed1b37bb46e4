// A surface as its normals tell of it (picture/facet.glsl).
const float ALBEDO_MOST = 1.0;

vec3 sent_by_facet(vec3 color, inout vec3 normal) {
    return color;
}
