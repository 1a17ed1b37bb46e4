// Points of volumes of visibility alone: their light does not matter.
vec3 point_irradiance_at(vec3 position, vec3 normal) {
    return vec3(0.0);
}
