/* Which lights each slot of a pattern takes, and each one's weight there: of a group of many, one stands for all. */
#ifndef PASSES_LIGHT_PICKS_H
#define PASSES_LIGHT_PICKS_H

struct frame;
struct light_layout;

struct light_picks {
    float (*items)[2]; /* of each slot: a light's number and weight */
    int stride;        /* room for a slot's */
};

void light_picks_init(struct light_picks *picks, const struct light_layout *layout);
void light_picks_free(struct light_picks *picks);

/* Deals the frame's lights out to that many slots, by their flux; returns how many each takes. */
int light_picks_deal(const struct light_picks *picks, const struct frame *frame, int slots);

/* Sets so many of the slot's, from the first on, at LOCATION_PICK_COUNT and LOCATION_PICKS. */
void light_picks_set(const struct light_picks *picks, int slot, int first, int count);

#endif
