/* Which lights each slot of a pattern takes, and each one's weight there: of a group of many, one stands for all. */
#ifndef PASSES_SLOT_LIGHTS_H
#define PASSES_SLOT_LIGHTS_H

struct frame;
struct light_layout;

struct slot_lights {
    float (*items)[2]; /* of each slot: a light's number and weight */
    int stride;        /* room for a slot's */
};

void slot_lights_init(struct slot_lights *lights, const struct light_layout *layout);
void slot_lights_free(struct slot_lights *lights);

/* Allocates the frame's lights to that many slots, by their flux; returns how many each takes. */
int slot_lights_allocate(const struct slot_lights *lights, const struct frame *frame, int slots);

/* Sets so many of the slot's, from the first on, at LOCATION_SLOT_LIGHT_COUNT and LOCATION_SLOT_LIGHTS. */
void slot_lights_set(const struct slot_lights *lights, int slot, int first, int count);

#endif
