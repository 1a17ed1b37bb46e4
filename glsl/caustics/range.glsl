// How far light of a ray comes from its light, metres: by chance, so that the light's range is right on average anywhere.
float comes_by_chance(light l, float number) {
    return l.range_inverse2 > 0.0 ? sqrt(sqrt(1.0 - number) / l.range_inverse2) : 1e30;
}
