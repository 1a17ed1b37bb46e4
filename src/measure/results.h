/* What was measured, as long rows: one for each figure of each subject.
 *
 * The CSV file has one shape whatever was measured, and every row tells subject and machine, so
 * that rows of many runs may be put together:
 *
 *     mode, scene, faces, width, height, technique, variant, point, settings    the subject
 *     what, against, unit, value, p5, p95, min, max, count                      the figure
 *     frame_ms                     the time of the subject's frame by the clock, where it was taken
 *     ns_per_pixel, ns_per_pixel_vpl                                            of times
 *     gl_vendor, gl_renderer, gl_version, software, cpu, cores, commit, date    the machine
 */
#ifndef MEASURE_RESULTS_H
#define MEASURE_RESULTS_H

#include "measure/measure.h"
#include "metrics/summary.h"

struct result {
    int subject;
    char what[TIMER_PATH_SIZE]; /* "frame/gather", "clock", "relative-rmse" */
    const char *against;        /* of an error: what holds the truth; else "" */
    const char *unit;           /* "ms", "MiB", "%", "1" ... */
    struct summary figure;
};

struct subject {
    struct measure_desc desc; /* the stage is not there any more */
    char scene[SCENE_NAME_SIZE];
    unsigned faces;
};

/* Whether both are of one scene, in one size. */
bool subject_is_beside(const struct subject *a, const struct subject *b);

/* Zeroed: none. */
struct results {
    struct subject *subjects;
    struct result *rows;
    int subject_count, row_count;
};

void results_free(struct results *results);

/* What is added from now on is of this subject. */
void results_begin(struct results *results, const struct measure_desc *desc);
void results_add(struct results *results, const char *what, const char *against, const char *unit,
                 double value);
void results_add_summary(struct results *results, const char *what, const char *against,
                         const char *unit, const struct summary *figure);

/* The first row of the subject and that name; against NULL = whatever. NULL: there is none. */
const struct result *results_find(const struct results *results, int subject, const char *what,
                                  const char *against);

/* The same, its value; 0 where there is none. */
double results_value(const struct results *results, int subject, const char *what,
                     const char *against);

/* Of the unit "x", places on a curve, 0 and infinity are shown as beyond its ends. */
enum { COLUMNS_MAX = 8 };

struct table {
    const char *title;
    struct {
        const char *heading, *what, *against;
    } columns[COLUMNS_MAX + 1]; /* up to the first of no heading */
};

/* On stdout: a line for each subject from the first on that has any of the columns, below a heading
 * for each scene and size. */
void results_print(const struct results *results, int first, const struct table *table);

/* On stdout: the cells that tell the machine, of the current context. */
void results_print_machine(void);

/* Error: of the file. */
bool results_write(const struct results *results, const char *mode, const char *path);

#endif
