#include "lab/measure/results.h"

#include "base/memory.h"

#include <math.h>
#include <stdio.h>
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

void results_begin(struct results *results, const struct measure_desc *desc) {
    size_t count = (size_t)results->subject_count++;
    results->subjects = mem_resize(results->subjects, count + 1, sizeof *results->subjects);
    results->subjects[count] = subject_of(desc);
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

bool results_commit(struct results *results) {
    results->committed = results->subject_count;
    return !results->listener || results->listener(results->user);
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
