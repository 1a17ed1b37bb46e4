/* Where reflected light starts: lights without a size, which stand for those that shine.
 *
 * Seen from its middle alone, a light as wide as a room leaves dark what only its rim sees. So a wide
 * light falls into pieces, at a few places of it (emitter_piece), each with views of its own; a small one
 * stays whole. Each pass of a picture that converges takes other places, and those of small lights too:
 * the mean is the light's. A sky starts from a few directions, each with a view of its own.
 */
#ifndef LIGHTS_STARTS_H
#define LIGHTS_STARTS_H

#include "lights/sky.h"
#include "lights/view.h"

/* What was one light, among the starts. */
struct light_group {
    int first, count;
};

struct light_starts {
    struct emitter items[LIGHTS_MAX];
    int count;
    struct light_group groups[LIGHTS_MAX];
    int group_count;
};

/* Lights of the emitters' sky, in the groups that starts stand for. */
struct starts_sky {
    const struct environment_lights *lights;
    const struct sky_groups *groups;
};

struct starts_desc {
    int places;   /* that wide lights have, all together; each has one at least */
    float wide;   /* what is wider falls into pieces: over the radius; of a sun, rad */
    float radius; /* of the scene, m */
};

/* Of emitters that have a layout; groups of their sky come last, as directional lights, for which there is
 * room. Fewer places where all would not fit in one; how many does not depend
 * on the pass. */
void light_starts_place(struct light_starts *starts, const struct emitters *emitters,
                        const struct starts_sky *sky, const struct starts_desc *desc, int pass);

struct emitters light_starts_emitters(struct light_starts *starts);

struct light_layout light_starts_layout(struct light_starts *starts);

#endif
