#include "passes/light_picks.h"

#include "base/deal.h"
#include "base/memory.h"
#include "gl/pass.h"
#include "lights/light_samples.h"
#include "passes/frame.h"

#include <stdlib.h>

enum { SLOTS_MAX = 16 * 16 }; /* of a pattern */

void light_picks_init(struct light_picks *picks, const struct light_layout *layout) {
    *picks = (struct light_picks){.stride = layout->lights};
    picks->items = mem_alloc((size_t)(SLOTS_MAX * layout->lights), sizeof *picks->items);
}

void light_picks_free(struct light_picks *picks) {
    free(picks->items);
    *picks = (struct light_picks){0};
}

/* As few of the group for each slot as show all; they follow those that are picked already. Returned is how many
 * there are. */
static int deal_group(const struct light_picks *picks, const struct frame *frame,
                      struct light_group group, int slots, int picked) {
    double fluxes[LIGHTS_MAX];
    struct dealt dealt[SLOTS_MAX + LIGHTS_MAX];
    int counts[LIGHTS_MAX];
    for (int i = 0; i < group.count; i++)
        fluxes[i] = emitter_flux(&frame->emitters->items[group.first + i], frame->radius);
    int each = (group.count + slots - 1) / slots;
    deal(fluxes, group.count, dealt, slots * each, counts);
    for (int slot = 0; slot < slots; slot++)
        for (int i = 0; i < each; i++) {
            int light = dealt[slot + i * slots].taker;
            float *pick = picks->items[slot * picks->stride + picked + i];
            pick[0] = (float)(group.first + light);
            pick[1] = (float)slots / (float)counts[light];
        }
    return picked + each;
}

int light_picks_deal(const struct light_picks *picks, const struct frame *frame, int slots) {
    int picked = 0;
    for (int g = 0; g < frame->layout.groups; g++)
        picked = deal_group(picks, frame, frame->groups[g], slots, picked);
    return picked;
}

void light_picks_set(const struct light_picks *picks, int slot, int first, int count) {
    pass_set_int(LOCATION_PICK_COUNT, count);
    pass_set_pairs(LOCATION_PICKS, count, picks->items[slot * picks->stride + first]);
}
