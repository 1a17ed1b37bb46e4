// Numbers from 0 to 1 for choices: random ones, even ones, and choices that stretch the rest of a number.

// Two numbers, the same ones for the same three integers [Jarzynski and Olano 2020, pcg3d].
vec2 random_of(uvec3 seed) {
    uvec3 v = seed * 1664525u + 1013904223u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v ^= v >> 16u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    return vec2(v.xy >> 8u) / 16777216.0;
}

// Numbers from 0 to 1 that lie evenly however many are taken: fractions of multiples of an irrational number [Roberts 2018],
// in 32 bits. Sums of integers are exact: where one number chooses among many, no driver's rounding chooses another.
const uvec2 LATTICE_PLASTIC = uvec2(3242174889u, 2447445414u); // of the plastic number, and of its square, over 1
const uint LATTICE_GOLDEN = 2654435769u, LATTICE_ROOT_2 = 1779033704u, LATTICE_ROOT_3 = 3144134278u; // their fractions

float lattice_number(uint turns) {
    return float(turns >> 8u) / 16777216.0;
}

// One of many, picked in proportion to its weight while they come: whether this one stands for all up to it, which weigh `sum`.
// One number serves all: within the part that it fell into it is as random as before.
bool weighted_pick(float own, float sum, inout float random) {
    float share = own / max(sum, 1e-30);
    bool taken = random < share;
    random = (taken ? random : random - share) / max(taken ? share : 1.0 - share, 1e-6);
    return taken;
}

// Which half x lies in; x is stretched over this half.
int take_half(inout float x, float first, float second) {
    float share = first / max(first + second, 1e-30);
    bool is_first = x < share;
    x = is_first ? x / share : (x - share) / max(1.0 - share, 1e-6);
    x = min(x, 0.999999);
    return is_first ? 0 : 1;
}

// Returns a 2D low-discrepancy sample for a ray of a pixel. Samples of one pixel, and of neighbouring pixels, are well
// separated. start: offset of the pass.
vec2 pixel_sample(ivec2 pixel, vec2 start, int ray) {
    const vec2 STEP = vec2(LATTICE_PLASTIC) / 4294967296.0;
    vec2 shift = vec2(dot(vec2(pixel), STEP), dot(vec2(pixel), vec2(0.8191725134, 0.6710436067)));
    return fract(fract(shift) + start + float(ray) * STEP);
}
