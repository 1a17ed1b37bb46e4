/* Finds faults that the error alone does not explain: the picture is right except for one
 * unintended change. */
#ifndef LAB_SCORE_FAULTS_H
#define LAB_SCORE_FAULTS_H

#include "base/image.h"

#include <stdbool.h>

enum picture_fault {
    FAULT_EXPOSURE,   /* the whole picture is brighter or darker by one factor */
    FAULT_ENCODED,    /* sRGB-encoded instead of linear */
    FAULT_MIRRORED,   /* left and right, or top and bottom, are exchanged */
    FAULT_SHIFTED,    /* shifted by .25 to 2 pixels */
    FAULT_OTHER_VIEW, /* even coarse bright and dark areas differ */
    FAULT_FIREFLIES,  /* single pixels far brighter than the reference around them */
    FAULT_COUNT
};

/* For output: "exposure", "encoded" ... */
extern const char *const picture_fault_names[FAULT_COUNT];

struct picture_faults {
    bool found[FAULT_COUNT];
    double exposure;    /* picture over reference */
    bool mirrored[2];   /* horizontally, vertically */
    double shift[2];    /* pixels, to the right and down */
    int firefly_count;  /* pixels */
    double correlation; /* correlation of bright and dark areas, in boxes */
};

/* Finds the faults. Both pictures have three finite linear channels R G B and the same size. At
 * most one of the first three faults is found: the change whose removal lowers the error most, and
 * clearly. If none is found, FAULT_OTHER_VIEW is tested; if the view is right, shift and
 * fireflies. */
void picture_faults_find(const struct image *picture, const struct image *reference,
                         struct picture_faults *faults);

/* Returns a sentence without its full stop. The caller frees it. */
char *picture_fault_describe(const struct picture_faults *faults, enum picture_fault fault);

#endif
