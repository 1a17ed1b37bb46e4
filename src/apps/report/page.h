/* The page of manylight report: HTML that needs no other file, no script and no network. */
#ifndef APPS_REPORT_PAGE_H
#define APPS_REPORT_PAGE_H

#include "apps/bench/measure/results.h"
#include "apps/bench/measure/variants.h"
#include "quality/quality.h"

struct report {
    const char *path; /* of the scene */
    const struct stage *stage;
    int width, height;
    struct measure_list subjects;
    struct image *pictures; /* of each subject, with all layers */
    struct image reference;
    double noise;           /* of the reference */
    struct results results; /* times and errors of the subjects, in their order */
    struct results flicker; /* of each subject; none where nothing moves */
    int flicker_frames;
    double asked; /* --max-error; 0 = nobody asked */
    struct quality_found found;
};

/* With a context, of which the page tells. Error: of a picture. */
bool page_print(FILE *out, const struct report *report);

#endif
