/* Whole things dealt out to takers by weight: samples to lights, as many as each is worth.
 *
 * By the divisor method of Sainte-Lague. Whoever has a weight gets at least one, as long as there
 * are enough; those of one taker are spread evenly among all, so that any run of them holds all
 * takers by weight.
 */
#ifndef BASE_DEAL_H
#define BASE_DEAL_H

/* A thing's taker, and which of the taker's own it is, from 0. */
struct dealt {
    int taker, number;
};

/* Weights are finite and not negative; where all are 0, all weigh alike. counts, unless NULL: how
 * many each taker gets. */
void deal(const double *weights, int taker_count, struct dealt *things, int thing_count,
          int *counts);

#endif
