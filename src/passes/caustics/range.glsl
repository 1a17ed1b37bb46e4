// How far a ray's light comes, metres. Chance chooses it, so that on average each place has the light
// of its range.
float comes_by_chance(light l, float number) {
    return l.range_inverse2 > 0.0 ? sqrt(sqrt(1.0 - number) / l.range_inverse2) : 1e30;
}
