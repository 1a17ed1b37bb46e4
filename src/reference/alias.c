#include "reference/alias.h"

#include "base/memory.h"

#include <math.h>

/* Fills the slots of those that weigh less than the mean with what others have above it. */
static void fill(struct alias *alias, double *parts, int *small, int *large) {
    int small_count = 0, large_count = 0;
    for (int i = 0; i < alias->count; i++)
        if (parts[i] < 1)
            small[small_count++] = i;
        else
            large[large_count++] = i;
    while (small_count > 0 && large_count > 0) {
        int to = small[--small_count], from = large[large_count - 1];
        alias->slots[to] = (struct alias_slot){(float)parts[to], from};
        parts[from] -= 1 - parts[to];
        if (parts[from] < 1) {
            large_count--;
            small[small_count++] = from;
        }
    }
    /* What is left is full but for rounding; and so nobody without weight is. */
    while (large_count > 0)
        alias->slots[large[--large_count]].share = 1;
    while (small_count > 0)
        alias->slots[small[--small_count]].share = 1;
}

void alias_init(struct alias *alias, const double *weights, int count) {
    size_t size = (size_t)count;
    double *parts = mem_alloc(size, sizeof *parts), sum = 0;
    int *order = mem_alloc(2 * size, sizeof *order);
    *alias = (struct alias){count, mem_alloc(size, sizeof *alias->slots)};
    for (int i = 0; i < count; i++)
        sum += weights[i];
    for (int i = 0; i < count; i++)
        parts[i] = weights[i] / sum * count;
    fill(alias, parts, order, order + count);
    mem_free(parts, order);
}

void alias_free(struct alias *alias) {
    free(alias->slots);
    *alias = (struct alias){0};
}

int alias_pick(const struct alias *alias, float *number) {
    const float below_one = 0x1.fffffep-1F;
    float place = *number * (float)alias->count;
    int slot = (int)place < alias->count ? (int)place : alias->count - 1;
    float part = fminf(place - (float)slot, below_one), share = alias->slots[slot].share;
    if (part < share) {
        *number = fminf(part / share, below_one);
        return slot;
    }
    *number = fminf((part - share) / (1 - share), below_one);
    return alias->slots[slot].other;
}
