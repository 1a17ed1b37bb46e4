#include "base/deal.h"

#include "base/memory.h"

#include <stdbool.h>

/* Takers in a heap: each comes before those below it. */
struct queue {
    const double *weights;
    int *got, *takers, count;
};

/* The greater weight / (2 got + 1), or the first of equal ones. */
static bool comes_before(const struct queue *queue, int a, int b) {
    double of_a = queue->weights[a] * (2 * queue->got[b] + 1);
    double of_b = queue->weights[b] * (2 * queue->got[a] + 1);
    return of_a != of_b ? of_a > of_b : a < b;
}

static void sink(struct queue *queue, int at) {
    int *takers = queue->takers;
    for (int child = 2 * at + 1; child < queue->count; child = 2 * at + 1) {
        if (child + 1 < queue->count && comes_before(queue, takers[child + 1], takers[child]))
            child++;
        if (!comes_before(queue, takers[child], takers[at]))
            return;
        int sinks = takers[at];
        takers[at] = takers[child];
        takers[child] = sinks;
        at = child;
    }
}

static struct queue queue_make(const double *weights, int *got, int count) {
    struct queue queue = {weights, got, mem_alloc((size_t)count, sizeof *queue.takers), count};
    for (int i = 0; i < count; i++)
        queue.takers[i] = i;
    for (int i = count / 2 - 1; i >= 0; i--)
        sink(&queue, i);
    return queue;
}

/* Gives one thing to the next taker. */
static int take(struct queue *queue) {
    int taker = queue->takers[0];
    queue->got[taker]++;
    sink(queue, 0);
    return taker;
}

/* Each weight above 0 has one first, the greatest before others: with none got, they come first in
 * a queue of these weights. */
static void count_shares(const double *weights, int taker_count, int thing_count, int *counts) {
    int *firsts = mem_alloc((size_t)taker_count, sizeof *firsts), given = 0;
    struct queue queue = queue_make(weights, firsts, taker_count);
    while (given < thing_count && queue.count > 0 && weights[queue.takers[0]] > 0) {
        counts[queue.takers[0]] = 1;
        queue.takers[0] = queue.takers[--queue.count];
        sink(&queue, 0);
        given++;
    }
    mem_free(queue.takers, firsts);
    queue = queue_make(weights, counts, taker_count);
    for (; given < thing_count; given++)
        take(&queue);
    free(queue.takers);
}

/* As weights, whole shares come out as they are, and the first of a small one not at the front. */
static void spread(const int *counts, int taker_count, struct dealt *things, int thing_count) {
    double *weights = mem_alloc((size_t)taker_count, sizeof *weights);
    int *got = mem_alloc((size_t)taker_count, sizeof *got);
    for (int i = 0; i < taker_count; i++)
        weights[i] = counts[i];
    struct queue queue = queue_make(weights, got, taker_count);
    for (int i = 0; i < thing_count; i++) {
        int taker = take(&queue);
        things[i] = (struct dealt){taker, got[taker] - 1};
    }
    mem_free(weights, got, queue.takers);
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
