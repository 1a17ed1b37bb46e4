// A material that is diffuse, whatever its textures say (picture/surface_detail.glsl).
vec3 mapped_normal(vec3 normal) {
    return normal;
}

bool is_unlit() {
    return false;
}

vec3 albedo_of(vec3 base, vec3 normal, vec3 towards, bool of_light, bool is_back) {
    return base;
}
