/* Lamps that are surfaces: which elements are of which, and how much light each gives in a frame. */
#ifndef TECHNIQUES_IMPLICIT_VISIBILITY_LAMPS_H
#define TECHNIQUES_IMPLICIT_VISIBILITY_LAMPS_H

#include "scene/lights/emitter.h"
#include "techniques/implicit-visibility/elements.h"

struct lamps {
    int count;         /* 1 + the greatest number of a lamp; 0 stands for all together */
    double (*own)[3];  /* of each lamp, as the scene has it, W/sr */
    float (*share)[3]; /* of its own light that each gives; lamps_follow */
    int *of_elements;  /* each element's lamp; 0: not known */
};

/* Of elements that the geometry has, in their order. */
void lamps_init(struct lamps *lamps, const struct scene *scene, const struct geometry *geometry,
                const struct elements *elements);
void lamps_free(struct lamps *lamps);

/* Takes the lamps' light from what shines. */
void lamps_follow(struct lamps *lamps, const struct emitters *emitters);

#endif
