#include "apps/bench/measure/results.h"

#include "apps/bench/measure/journal.h"
#include "base/memory.h"
#include "scene/hash.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

void results_free(struct results *results) {
    mem_free(results->subjects, results->rows);
    *results = (struct results){0};
}

void results_set_date(char date[16]) {
    time_t now = time(NULL);
    strftime(date, 16, "%Y-%m-%d", gmtime(&now));
}

static struct subject subject_of(const struct measure_desc *desc) {
    struct subject subject = {.desc = *desc,
                              .faces = geometry_triangle_count(&desc->stage->geometry)};
    memcpy(subject.scene, desc->stage->name, sizeof subject.scene);
    subject.desc.stage = NULL;
    results_set_date(subject.date);
    return subject;
}

static void begin(struct results *results, const struct subject *subject) {
    size_t count = (size_t)results->subject_count++;
    results->subjects = mem_resize(results->subjects, count + 1, sizeof *results->subjects);
    results->subjects[count] = *subject;
}

void results_begin(struct results *results, const struct measure_desc *desc) {
    struct subject subject = subject_of(desc);
    begin(results, &subject);
}

void results_add_summary(struct results *results, const char *what, const char *against,
                         const char *unit, const struct summary *figure) {
    size_t count = (size_t)results->row_count++;
    results->rows = mem_resize(results->rows, count + 1, sizeof *results->rows);
    struct result *row = &results->rows[count];
    *row = (struct result){
        .subject = results->subject_count - 1, .against = against, .unit = unit, .figure = *figure};
    snprintf(row->what, sizeof row->what, "%s", what);
}

void results_add(struct results *results, const char *what, const char *against, const char *unit,
                 double value) {
    results_add_summary(results, what, against, unit,
                        &(struct summary){value, value, value, value, value, 1});
}

/* --- runs that are taken up --------------------------------------------------------------------- */

void results_set_stage(struct results *results, const struct stage *stage) {
    if (results->journal)
        results->scene =
            scene_hash(&stage->scene, &stage->geometry, &stage->camera, &stage->emitters);
}

static void tell(const struct results *results, bool resumed) {
    if (results->listener)
        results->listener(results->user, resumed);
}

bool results_resume(struct results *results, const struct measure_desc *desc, bool *resumed) {
    int rows;
    *resumed = false;
    if (!results->journal)
        return true;
    struct subject subject = subject_of(desc);
    const struct result *first = journal_next(results->journal, &subject, results->scene, &rows);
    if (!first)
        return rows == 0;
    begin(results, &subject);
    for (int i = 0; i < rows; i++)
        results_add_summary(results, first[i].what, first[i].against, first[i].unit,
                            &first[i].figure);
    results->committed = results->subject_count;
    *resumed = true;
    tell(results, true);
    return true;
}

bool results_commit(struct results *results) {
    int first = results->committed;
    results->committed = results->subject_count;
    if (results->journal && !journal_append(results->journal, results, first, results->scene))
        return false;
    tell(results, false);
    return true;
}

void results_tell_work(const struct results *results, const struct measure_desc *desc,
                       double subjects) {
    if (results->work_listener)
        results->work_listener(results->user, desc, subjects);
}

/* --- looking up ------------------------------------------------------------------------------- */

const struct result *results_find(const struct results *results, int subject, const char *what,
                                  const char *against) {
    for (const struct result *r = results->rows; r < results->rows + results->row_count; r++)
        if (r->subject == subject && strcmp(r->what, what) == 0 &&
            (!against || strcmp(r->against, against) == 0))
            return r;
    return NULL;
}

double results_value(const struct results *results, int subject, const char *what,
                     const char *against) {
    const struct result *row = results_find(results, subject, what, against);
    return row ? row->figure.value : 0;
}

/* --- tables ----------------------------------------------------------------------------------- */

/* The subject's rows of the table's columns. Returns whether there is any. */
static bool find_line(const struct results *results, int subject, const struct table *table,
                      const struct result *line[COLUMNS_MAX]) {
    bool any = false;
    for (int i = 0; table->columns[i].heading; i++) {
        line[i] = results_find(results, subject, table->columns[i].what, table->columns[i].against);
        any = any || line[i];
    }
    return any;
}

bool subject_is_beside(const struct subject *a, const struct subject *b) {
    return strcmp(a->scene, b->scene) == 0 && a->faces == b->faces &&
           a->desc.width == b->desc.width && a->desc.height == b->desc.height;
}

static void print_heading(const struct subject *subject, const struct table *table) {
    printf("%s: %s, %u faces, %dx%d\n  %-24s %-24s", table->title, subject->scene, subject->faces,
           subject->desc.width, subject->desc.height, "variant", "");
    for (int i = 0; table->columns[i].heading; i++)
        printf(" %10s", table->columns[i].heading);
    printf("\n");
}

static void print_value(const struct result *row) {
    bool of_curve = row && strcmp(row->unit, "x") == 0;
    if (of_curve && (row->figure.value == 0 || isinf(row->figure.value)))
        printf(" %10s", row->figure.value > 0 ? "> curve" : "< curve");
    else if (row)
        printf(" %10.*f", strcmp(row->unit, "1") == 0 ? 4 : *row->unit ? 2 : 0, row->figure.value);
    else
        printf(" %10s", "-");
}

int results_print(const struct results *results, int first, const struct table *table, int last) {
    for (int i = first; i < results->subject_count; i++) {
        const struct subject *subject = &results->subjects[i];
        const struct result *line[COLUMNS_MAX];
        if (!find_line(results, i, table, line))
            continue;
        if (last < 0 || !subject_is_beside(&results->subjects[last], subject))
            print_heading(subject, table);
        last = i;
        printf("  %-24s %-24s", subject->desc.variant, subject->desc.point);
        for (int k = 0; table->columns[k].heading; k++)
            print_value(line[k]);
        printf("\n");
    }
    return last;
}
