/* Owen-scrambled Sobol points [Burley 2020, Practical Hash-based Owen Scrambling].
 *
 * A sample of a pixel draws pairs of numbers. Each pair has its own scrambled and shuffled
 * (0,2)-sequence, so any first 2^k samples are stratified in every pair. Points depend only on the
 * seeds, not on threads or the order of work. */
#ifndef REFERENCE_SAMPLER_H
#define REFERENCE_SAMPLER_H

#include <stdint.h>

#include "base/unit.h"

struct sampler {
    uint32_t seed;  /* seed of the sequence: of a pixel and a stream */
    uint32_t index; /* index of the sample in the sequence */
    uint32_t pair;  /* next pair to draw */
};

/* Returns a well-mixed hash of both, to make seeds of several numbers. */
uint32_t sampler_hash(uint32_t seed, uint32_t value);

/* Replaces a pair: returns the index of the sample's `count` points, a power of two, in a prepared
 * sequence. The points are index xor 0 to count - 1. Bits are flipped at random by sequence and
 * pair; the first 2^k samples take an aligned run of points. */
uint32_t sampler_next_run(struct sampler *sampler, uint32_t count);

/* Returns the next pair, each in [0, 1). */
vec2s sampler_next(struct sampler *sampler);

#endif
