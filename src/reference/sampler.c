#include "reference/sampler.h"

/* PCG-RXS-M-XS, the hash that [Jarzynski and Olano 2020] recommend. */
static uint32_t mix(uint32_t x) {
    x = x * 747796405u + 2891336453u;
    x = ((x >> ((x >> 28) + 4)) ^ x) * 277803737u;
    return (x >> 22) ^ x;
}

uint32_t sampler_hash(uint32_t seed, uint32_t value) {
    return mix(seed ^ mix(value));
}

static uint32_t reverse_bits(uint32_t x) {
    x = (x >> 1 & 0x55555555u) | (x & 0x55555555u) << 1;
    x = (x >> 2 & 0x33333333u) | (x & 0x33333333u) << 2;
    x = (x >> 4 & 0x0f0f0f0fu) | (x & 0x0f0f0f0fu) << 4;
    return __builtin_bswap32(x);
}

/* Flips each bit by a hash of the bits below it [Laine and Karras 2011, §3.1; constants of Burley
 * 2020]: an Owen scrambling of the number whose digits are the bits from the lowest up. */
static uint32_t scramble_reversed(uint32_t x, uint32_t seed) {
    x += seed;
    x ^= x * 0x6c50b47cu;
    x ^= x * 0xb82f1e52u;
    x ^= x * 0xc7afe638u;
    x ^= x * 0x8d22f6e6u;
    return x;
}

/* The second Sobol dimension, bit-reversed. Its matrix holds the binomials (j over i) mod 2, which
 * are 1 where the bits of i are among those of j: hence a sum over supersets, in five steps. */
static uint32_t sobol_reversed(uint32_t x) {
    x ^= x >> 1 & 0x55555555u;
    x ^= x >> 2 & 0x33333333u;
    x ^= x >> 4 & 0x0f0f0f0fu;
    x ^= x >> 8 & 0x00ff00ffu;
    x ^= x >> 16 & 0x0000ffffu;
    return x;
}

static float to_unit_interval(uint32_t x) {
    return (float)(x >> 8) * 0x1p-24f;
}

uint32_t sampler_next_run(struct sampler *sampler, uint32_t count) {
    return sampler->index * count ^ sampler_hash(sampler->seed, sampler->pair++);
}

vec2s sampler_next(struct sampler *sampler) {
    uint32_t seed = sampler_hash(sampler->seed, sampler->pair++);
    /* The shuffle keeps the two sequences of different pairs apart. */
    uint32_t index = reverse_bits(scramble_reversed(reverse_bits(sampler->index), seed));
    uint32_t x = scramble_reversed(index, mix(seed + 1));
    uint32_t y = scramble_reversed(sobol_reversed(index), mix(seed + 2));
    return (vec2s){{to_unit_interval(reverse_bits(x)), to_unit_interval(reverse_bits(y))}};
}
