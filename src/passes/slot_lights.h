/* Lights of each interleave slot, with weights: one light can represent several of its group. */
#ifndef PASSES_SLOT_LIGHTS_H
#define PASSES_SLOT_LIGHTS_H

struct frame;
struct light_layout;

struct slot_lights {
    float (*items)[2]; /* items of each slot: light number, weight */
    int stride;        /* most lights of a slot */
};

void slot_lights_init(struct slot_lights *lights, const struct light_layout *layout);
void slot_lights_free(struct slot_lights *lights);

/* Allocates the frame's lights to `slots` slots by flux. Returns the number of lights a slot. */
int slot_lights_allocate(const struct slot_lights *lights, const struct frame *frame, int slots);

/* Sets lights first to first + count - 1 of the slot as uniforms LOCATION_SLOT_LIGHT_COUNT and
 * LOCATION_SLOT_LIGHTS. */
void slot_lights_set(const struct slot_lights *lights, int slot, int first, int count);

#endif
