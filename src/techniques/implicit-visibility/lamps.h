/* Emissive surfaces as lamps: the elements of each lamp, and its light in a frame. */
#ifndef TECHNIQUES_IMPLICIT_VISIBILITY_LAMPS_H
#define TECHNIQUES_IMPLICIT_VISIBILITY_LAMPS_H

#include "scene/lights/emitter.h"
#include "techniques/implicit-visibility/elements.h"

struct lamps {
    int count;         /* 1 + the greatest lamp number; lamp 0 is all lamps together */
    double (*own)[3];  /* radiant intensity of each lamp in the scene, W/sr */
    float (*share)[3]; /* fraction of its own light in this frame; lamps_follow */
    int *of_elements;  /* lamp of each element; 0: unknown */
};

/* Finds the lamps of elements, which are in the geometry's order. */
void lamps_init(struct lamps *lamps, const struct scene *scene, const struct geometry *geometry,
                const struct elements *elements);
void lamps_free(struct lamps *lamps);

/* Updates the lamps' light from the shining emitters. */
void lamps_follow(struct lamps *lamps, const struct emitters *emitters);

#endif
