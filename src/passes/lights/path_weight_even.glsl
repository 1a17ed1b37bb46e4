// Surfaces that light walks to count by flux alone.
float walk_weight(vec3 position, vec3 normal) {
    return 1.0;
}
