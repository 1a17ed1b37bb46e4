/* The failure suite: known ways in which many-light methods break, each a small scene or a setting,
 * drawn in several ways and held against rays. docs/notes/failures.md says why each breaks and what
 * does better.
 *
 * What is promised of each technique lies in its folder, src/techniques/NAME/bounds.csv: at most so
 * many per cent of relative RMSE and of relative bias, at 160x120 and 2 % noise, and in small, as
 * `make test` runs it. The program holds these files. */
#ifndef LAB_MEASURE_FAILURES_H
#define LAB_MEASURE_FAILURES_H

#include "lab/measure/results.h"
#include "lab/measure/reference.h"
#include "gl/context/context.h"

struct failure_row {
    const char *name;
    const char *scene;    /* file */
    const char *camera;   /* as scene/placing.h has it; NULL = the first */
    const char *settings; /* "key=value,..." over each column's own; NULL = none */
    int width, height;    /* 0 = as asked for */
};

/* End with a row of no name. */
extern const struct failure_row failure_rows[];

enum { FAILURE_COLUMNS = 11 };

/* Ways to draw each row, as variant_apply has it. */
extern const char *const failure_columns[FAILURE_COLUMNS];

/* Error: names all rows. */
const struct failure_row *failure_row_find(const char *name);

struct failure_desc {
    int width, height;
    const struct text_list *settings; /* of all columns, below the row's; NULL = none */
    struct reference_desc reference;  /* REFERENCE_CENTERS: without the error of edges */
    const struct context *context;    /* its messages count */
    bool small;                       /* hold results to the bounds of small pictures */
    unsigned columns;                 /* bits of failure_columns; 0 = all */
    const char
        *pictures; /* folder for ROW.exr: layers of the reference and of each column; NULL = none */
};

/* Adds a subject for each of these columns, whose point is the row's name:
 *     what errors_add adds, worst (pixel: |v - r| over the reference's mean) in %, non-finite
 *     (values), messages (of OpenGL), rmse-bound, bias-bound, and holds: 1 where it is finite,
 *     silent and within bounds
 * Errors over a black reference are infinite. Error: of the scene, the renderer or a file. */
bool failure_measure(struct results *results, const struct failure_row *row,
                     const struct failure_desc *desc);

#endif
