// Numbers from 0 to 1 that lie evenly however many are taken: fractions of multiples of an irrational number [Roberts 2018],
// in 32 bits. Sums of integers are exact: where one number chooses among many, no driver's rounding chooses another.
const uvec2 LATTICE_PLASTIC = uvec2(3242174889u, 2447445414u); // of the plastic number, and of its square, over 1
const uint LATTICE_GOLDEN = 2654435769u, LATTICE_ROOT_2 = 1779033704u, LATTICE_ROOT_3 = 3144134278u; // their fractions

float lattice_number(uint turns) {
    return float(turns >> 8u) / 16777216.0;
}
