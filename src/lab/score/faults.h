/* Faults of a picture that its error alone does not tell: the picture is right but for one change that its sender did not
 * mean. */
#ifndef LAB_SCORE_FAULTS_H
#define LAB_SCORE_FAULTS_H

#include "base/image.h"

#include <stdbool.h>

enum picture_fault {
    FAULT_EXPOSURE,   /* all of it is brighter or darker by one factor */
    FAULT_ENCODED,    /* it is sRGB-encoded where linear light is stored */
    FAULT_MIRRORED,   /* left and right, or top and bottom, are exchanged */
    FAULT_SHIFTED,    /* by a part of a pixel */
    FAULT_OTHER_VIEW, /* even its coarse lights and darks are others */
    FAULT_FIREFLIES,  /* single pixels far brighter than all around in the reference */
    FAULT_COUNT
};

/* For output: "exposure", "encoded" ... */
extern const char *const picture_fault_names[FAULT_COUNT];

struct picture_faults {
    bool found[FAULT_COUNT];
    double exposure;    /* the picture's over the reference's */
    bool mirrored[2];   /* across, down */
    double shift[2];    /* pixels, to the right and down */
    int firefly_count;  /* pixels */
    double correlation; /* of lights and darks, in boxes */
};

/* Both have three channels, linear R G B, finite, and the same size. Of the first three at most one is found: the change
 * without which the error is least, if that is well below the error as it is. The others are looked for where none is. */
void picture_faults_find(const struct image *picture, const struct image *reference,
                         struct picture_faults *faults);

/* A sentence without its full stop; free() frees. */
char *picture_fault_describe(const struct picture_faults *faults, enum picture_fault fault);

#endif
