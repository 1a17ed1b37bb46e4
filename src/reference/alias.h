/* Picks one of many by weight, in constant time: an alias table [Walker 1977; Vose 1991]. */
#ifndef REFERENCE_ALIAS_H
#define REFERENCE_ALIAS_H

struct alias {
    int count;
    struct alias_slot {
        float share; /* of the slot that is its own */
        int other;   /* who has the rest */
    } * slots;
};

/* Weights are finite and not negative, and not all 0. */
void alias_init(struct alias *alias, const double *weights, int count);

/* Accepts zeroed ones. */
void alias_free(struct alias *alias);

/* For a number in [0, 1), of which is left one in [0, 1) that has nothing to do with the pick, with as
 * many bits fewer as the count has. */
int alias_pick(const struct alias *alias, float *number);

#endif
