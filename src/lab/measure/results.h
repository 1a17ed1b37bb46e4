/* What was measured, as long rows: one for each figure of each subject. */
#ifndef LAB_MEASURE_RESULTS_H
#define LAB_MEASURE_RESULTS_H

#include "metrics/summary.h"
#include "quality/measure.h"

struct result {
    int subject;
    char what[TIMER_PATH_SIZE]; /* "frame/gather", "clock", "relative-rmse" */
    const char *against;        /* of an error: what holds the reference; else "" */
    const char *unit;           /* "ms", "MiB", "%", "1" ... */
    struct summary figure;
};

struct subject {
    struct measure_desc desc; /* the stage is not there any more */
    char scene[SCENE_NAME_SIZE];
    unsigned faces;
    char date[16]; /* of the measurement */
};

/* Whether both are of one scene, in one size. */
bool subject_is_beside(const struct subject *a, const struct subject *b);

/* Zeroed: none. */
struct results {
    struct subject *subjects;
    struct result *rows;
    int subject_count, row_count;
    int committed; /* subjects */
    /* Hear of what was committed, and of the work at hand. NULL: nobody. */
    bool (*listener)(void *user);
    void (*work_listener)(void *user, const struct measure_desc *desc, double subjects);
    void *user;
};

void results_free(struct results *results);

/* YYYY-MM-DD of now. */
void results_set_date(char date[16]);

/* What is added from now on is of this subject. */
void results_begin(struct results *results, const struct measure_desc *desc);
void results_add(struct results *results, const char *what, const char *against, const char *unit,
                 double value);
void results_add_summary(struct results *results, const char *what, const char *against,
                         const char *unit, const struct summary *figure);

/* All subjects begun so far are complete. Error: of the listener. */
bool results_commit(struct results *results);

/* The subject is at work, of which and of whose neighbours so many are measured. */
void results_tell_work(const struct results *results, const struct measure_desc *desc,
                       double subjects);

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
 * for each scene and size but that of the subject `last`, which was printed before; -1 = none was.
 * Returns the one that was printed last. */
int results_print(const struct results *results, int first, const struct table *table, int last);

#endif
