#include "passes/slot_lights.h"

#include "base/deal.h"
#include "base/memory.h"
#include "gl/pass.h"
#include "lights/light_samples.h"
#include "passes/frame.h"

#include <stdlib.h>

enum { SLOTS_MAX = 16 * 16 }; /* of a pattern */

void slot_lights_init(struct slot_lights *lights, const struct light_layout *layout) {
    *lights = (struct slot_lights){.stride = layout->lights};
    lights->items = mem_alloc((size_t)(SLOTS_MAX * layout->lights), sizeof *lights->items);
}

void slot_lights_free(struct slot_lights *lights) {
    free(lights->items);
    *lights = (struct slot_lights){0};
}

/* As few of the group for each slot as show all; they follow those that are allocated already.
 * Returned is how many there are. */
static int allocate_group(const struct slot_lights *lights, const struct frame *frame,
                          struct light_group group, int slots, int count) {
    double fluxes[LIGHTS_MAX];
    struct dealt dealt[SLOTS_MAX + LIGHTS_MAX];
    int counts[LIGHTS_MAX];
    for (int i = 0; i < group.count; i++)
        fluxes[i] = emitter_flux(&frame->emitters->items[group.first + i], frame->geometry->radius);
    int each = (group.count + slots - 1) / slots;
    deal(fluxes, group.count, dealt, slots * each, counts);
    for (int slot = 0; slot < slots; slot++)
        for (int i = 0; i < each; i++) {
            int light = dealt[slot + i * slots].taker;
            float *item = lights->items[slot * lights->stride + count + i];
            item[0] = (float)(group.first + light);
            item[1] = (float)slots / (float)counts[light];
        }
    return count + each;
}

int slot_lights_allocate(const struct slot_lights *lights, const struct frame *frame, int slots) {
    int count = 0;
    for (int g = 0; g < frame->layout.groups; g++)
        if (frame->emitters->items[frame->groups[g].first].type != EMITTER_MANY)
            count = allocate_group(lights, frame, frame->groups[g], slots, count);
    return count;
}

void slot_lights_set(const struct slot_lights *lights, int slot, int first, int count) {
    pass_set_int(LOCATION_SLOT_LIGHT_COUNT, count);
    pass_set_pairs(LOCATION_SLOT_LIGHTS, count, lights->items[slot * lights->stride + first]);
}
