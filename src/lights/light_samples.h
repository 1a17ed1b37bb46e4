/* Light samples: lights without a size, from which reflected light starts. Each has a view of its own.
 *
 * A wide light seen from its middle alone leaves dark what only its rim sees. It therefore splits into several
 * samples (emitter_piece). A small light is one sample, in its middle. Each pass of a progressive picture moves
 * all samples, so that the mean over passes is that of the whole light. An environment has a sample for each
 * group of its lights.
 */
#ifndef LIGHTS_LIGHT_SAMPLES_H
#define LIGHTS_LIGHT_SAMPLES_H

#include "lights/sky.h"
#include "lights/view.h"

/* The samples of one light. */
struct light_group {
    int first, count;
};

struct light_samples {
    struct emitter items[LIGHTS_MAX];
    int count;
    struct light_group groups[LIGHTS_MAX];
    int group_count;
    const struct environment *sky; /* of the last group; NULL: it is a light's */
};

/* Lights of the emitters' sky, in groups of one sample each. */
struct light_samples_sky {
    const struct environment_lights *lights;
    const struct sky_groups *groups;
};

struct light_samples_desc {
    int count;    /* of all wide lights together; each has at least one */
    float wide;   /* width from which a light has several samples: over the radius; of a sun, rad */
    float radius; /* of the scene, m */
};

/* Of emitters that have a layout. Groups of their sky come last, as directional lights, and must fit. A light
 * has fewer samples where all would not fit into a layout. Their number does not depend on the pass. */
void light_samples_place(struct light_samples *samples, const struct emitters *emitters,
                         const struct light_samples_sky *sky, const struct light_samples_desc *desc,
                         int pass);

/* Place k of n: Hammersley's, their mean in the middle, in each pass shifted on the torus. */
void light_samples_choose_place(float place[2], int k, int n, int pass);

struct emitters light_samples_emitters(struct light_samples *samples);

struct light_layout light_samples_layout(struct light_samples *samples);

#endif
