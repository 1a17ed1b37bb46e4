/* Owen-scrambled Sobol points: [Burley 2020, Practical Hash-based Owen Scrambling].
 *
 * Each sample of a pixel draws pairs of numbers; each pair comes from its own scrambled and
 * shuffled (0,2)-sequence, so that any first 2^k samples are stratified in every pair. The points
 * depend on the seeds alone, hence neither on threads nor on the order of the work.
 */
#ifndef REFERENCE_SAMPLER_H
#define REFERENCE_SAMPLER_H

#include <stdint.h>

#include "base/unit.h"

struct sampler {
    uint32_t seed;  /* of the sequence: of a pixel and a stream */
    uint32_t index; /* of the sample in the sequence */
    uint32_t pair;  /* the next to be drawn */
};

/* A well-mixed function of both, to build seeds of several numbers. */
uint32_t sampler_hash(uint32_t seed, uint32_t value);

/* In place of a pair: where the sample finds `count` points, a power of two, of a sequence made
 * beforehand, at the index returned xor 0 .. count - 1. Bits are flipped at random for the sequence
 * and the pair; the first 2^k samples take an aligned run of points. */
uint32_t sampler_next_run(struct sampler *sampler, uint32_t count);

/* The next pair, each in [0, 1). */
vec2s sampler_next(struct sampler *sampler);

#endif
