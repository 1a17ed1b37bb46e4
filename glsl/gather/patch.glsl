// Light of a patch that a point stands for, as a point has it: cos cos / d^2, and less within its radius,
//     cos cos d^2 / (d^4 + (A / pi)^2).
// Nearby, where maps hardly tell what is hidden, it takes less than a disk's 1 / (d^2 + A / pi), and farther off nearly
// nothing away, where that still does: in a corner it loses .7 of what the disk loses, inside a sphere pi / 2 of as many as
// there are, in place of ln(1 + P).
//
// scaled_cosines: times d each.
float patch_term(float scaled_cosines, float distance2, float area) {
    float radius2 = area * 0.31830988618;
    return scaled_cosines / (distance2 * distance2 + radius2 * radius2);
}
