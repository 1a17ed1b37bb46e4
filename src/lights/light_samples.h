/* Light samples: lights without a size from which reflected light starts, each with its own view.
 *
 * A single sample in the middle of a wide light would leave places dark that only its rim lights. A
 * wide light therefore has several samples (emitter_piece), a small light one in its middle. Each
 * pass of a progressive picture moves all samples, so the mean over passes is that of the whole
 * light. An environment has a sample for each group of its lights. */
#ifndef LIGHTS_LIGHT_SAMPLES_H
#define LIGHTS_LIGHT_SAMPLES_H

#include "lights/sky.h"
#include "lights/view.h"

/* Range of the samples of one light. */
struct light_group {
    int first, count;
};

struct light_samples {
    struct emitter items[LIGHTS_MAX];
    int count;
    struct light_group groups[LIGHTS_MAX];
    int group_count;
    const struct environment *sky; /* environment whose groups come last; NULL: none */
};

/* Environment lights of the emitters' sky and their groups, one sample each. */
struct light_samples_sky {
    const struct environment_lights *lights;
    const struct sky_groups *groups;
};

struct light_samples_desc {
    int count; /* samples of all wide lights together; each light has at least one */
    /* Width above which a light has several samples, as a fraction of radius; for suns, radians. */
    float wide;
    float radius; /* of the scene, m */
    bool many;    /* some lights are sampled */
    double flux;  /* of all sampled lights, W */
};

/* Places the samples of emitters that fit a layout. A light of EMITTER_MANY follows,
 * and then groups of their sky, as directional lights, which must fit. A light gets fewer samples
 * if all would not fit. The numbers do not depend on the pass. */
void light_samples_place(struct light_samples *samples, const struct emitters *emitters,
                         const struct light_samples_sky *sky, const struct light_samples_desc *desc,
                         int pass);

/* Computes point k of n in [0, 1)^2: a Hammersley point, shifted on the torus in each pass. In pass
 * 0 the mean is the middle. */
void light_samples_choose_place(float place[2], int k, int n, int pass);

struct emitters light_samples_emitters(struct light_samples *samples);

struct light_layout light_samples_layout(struct light_samples *samples);

#endif
