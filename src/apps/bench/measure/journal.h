/* The rows of a run that is not finished, on disk as they are measured, so that another run goes on from there.
 *
 * FILE.part lies beside the file that the run will write. It begins with the run's settings and machine as comments, and
 * then is CSV as in result_rows.h, with all digits: a block of rows for each results_commit, between lines that
 * begin with #. A run with other settings, of another machine or another commit does not go on with it.
 */
#ifndef APPS_BENCH_MEASURE_JOURNAL_H
#define APPS_BENCH_MEASURE_JOURNAL_H

#include "apps/bench/measure/results.h"

struct journal;

struct journal_desc {
    const char *path; /* of FILE */
    const char *mode; /* as result_rows have it */
    const char
        *identity; /* lines "name value", each with its end, of all that makes a run another one */
    bool restart;  /* drops the rows of a run that was broken off, whatever its settings */
};

/* With a context. NULL: an error: the file belongs to another run or to none, or cannot be written. */
struct journal *journal_open(const struct journal_desc *desc);

/* What a run that was broken off says of itself by that name, of the file beside that path; the caller frees it. NULL: there is no
 * such file or line. */
char *journal_value(const char *path, const char *name);

/* Accepts NULL. */
void journal_close(struct journal *journal);

/* The file is needed no more. Error: it cannot be removed. */
bool journal_finish(struct journal *journal);

/* How many subjects of the run before are left to be taken. */
int journal_left(const struct journal *journal);

/* Takes the rows of the next subject, so many, which live as long as the journal, and its date. NULL and 0: there is none.
 * NULL and -1: an error: it is another subject. */
const struct result *journal_next(struct journal *journal, struct subject *subject, uint64_t scene,
                                  int *rows);

/* All subjects from the first on become a block.. Error: of the file. */
bool journal_append(struct journal *journal, const struct results *results, int first,
                    uint64_t scene);

#endif
