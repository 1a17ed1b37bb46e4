#include "base/deal.h"

#include "base/memory.h"

#include <stdlib.h>

/* Who is next: the greatest weight / (2 got + 1). */
static int next_taker(const double *weights, const int *got, int count) {
    int best = 0;
    for (int i = 1; i < count; i++)
        if (weights[i] * (2 * got[best] + 1) > weights[best] * (2 * got[i] + 1))
            best = i;
    return best;
}

/* The greatest weight that has got none; -1 where there is none. */
static int next_without(const double *weights, const int *got, int count) {
    int best = -1;
    for (int i = 0; i < count; i++)
        if (got[i] == 0 && weights[i] > 0 && (best < 0 || weights[i] > weights[best]))
            best = i;
    return best;
}

static void count_shares(const double *weights, int taker_count, int thing_count, int *counts) {
    int without;
    for (int i = 0; i < thing_count; i++)
        if ((without = next_without(weights, counts, taker_count)) >= 0)
            counts[without]++;
        else
            counts[next_taker(weights, counts, taker_count)]++;
}

/* As weights, whole shares come out as they are, and the first of a small one not at the front. */
static void spread(const int *counts, int taker_count, struct dealt *things, int thing_count) {
    double *weights = mem_alloc((size_t)taker_count, sizeof *weights);
    int *got = mem_alloc((size_t)taker_count, sizeof *got);
    for (int i = 0; i < taker_count; i++)
        weights[i] = counts[i];
    for (int i = 0; i < thing_count; i++) {
        int taker = next_taker(weights, got, taker_count);
        things[i] = (struct dealt){taker, got[taker]++};
    }
    mem_free(weights, got);
}

void deal(const double *weights, int taker_count, struct dealt *things, int thing_count,
          int *counts) {
    double *alike = mem_alloc((size_t)taker_count, sizeof *alike), sum = 0;
    int *shares = mem_alloc((size_t)taker_count, sizeof *shares);
    for (int i = 0; i < taker_count; i++) {
        sum += weights[i];
        alike[i] = 1;
    }
    count_shares(sum > 0 ? weights : alike, taker_count, thing_count, shares);
    spread(shares, taker_count, things, thing_count);
    for (int i = 0; counts && i < taker_count; i++)
        counts[i] = shares[i];
    mem_free(alike, shares);
}
