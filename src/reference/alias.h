/* Samples an item by weight in constant time: an alias table [Walker 1977; Vose 1991]. */
#ifndef REFERENCE_ALIAS_H
#define REFERENCE_ALIAS_H

struct alias {
    int count;
    struct alias_slot {
        float share; /* fraction of the slot that selects itself */
        int other;   /* item that the rest of the slot selects */
    } * slots;
};

/* Builds the table. Weights must be finite, not negative and not all 0. */
void alias_init(struct alias *alias, const double *weights, int count);

/* Accepts a zeroed object. */
void alias_free(struct alias *alias);

/* Returns an item for a number in [0, 1). It replaces the number by an independent one in [0, 1),
 * which has log2(count) fewer bits. */
int alias_pick(const struct alias *alias, float *number);

#endif
