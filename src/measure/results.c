#include "measure/results.h"

#include "base/file/output_file.h"
#include "base/memory.h"
#include "base/parallel.h"
#include "base/text.h"

#include "version.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

void results_free(struct results *results) {
    free(results->subjects);
    free(results->rows);
    *results = (struct results){0};
}

void results_begin(struct results *results, const struct measure_desc *desc) {
    size_t count = (size_t)results->subject_count++;
    results->subjects = mem_resize(results->subjects, count + 1, sizeof *results->subjects);
    struct subject *subject = &results->subjects[count];
    *subject =
        (struct subject){.desc = *desc, .faces = geometry_triangle_count(&desc->stage->geometry)};
    memcpy(subject->scene, desc->stage->name, sizeof subject->scene);
    subject->desc.stage = NULL;
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

void results_print(const struct results *results, int first, const struct table *table) {
    const struct subject *last = NULL;
    for (int i = first; i < results->subject_count; i++) {
        const struct subject *subject = &results->subjects[i];
        const struct result *line[COLUMNS_MAX];
        if (!find_line(results, i, table, line))
            continue;
        if (!last || !subject_is_beside(last, subject))
            print_heading(subject, table);
        last = subject;
        printf("  %-24s %-24s", subject->desc.variant, subject->desc.point);
        for (int k = 0; table->columns[k].heading; k++)
            print_value(line[k]);
        printf("\n");
    }
}

/* --- the file --------------------------------------------------------------------------------- */

static void add_cell(struct text *line, const char *cell) {
    bool quoted = strpbrk(cell, ",\"\n");
    text_print(line, quoted ? ",\"" : ",");
    for (const char *c = cell; *c; c++)
        text_print(line, *c == '"' ? "\"\"" : "%c", *c);
    text_print(line, quoted ? "\"" : "");
}

static void add_cpu(struct text *line) {
    char info[256];
    const char *model = "unknown";
    FILE *file = fopen("/proc/cpuinfo", "r");
    while (file && fgets(info, sizeof info, file))
        if (strncmp(info, "model name", 10) == 0 && strchr(info, ':')) {
            info[strcspn(info, "\n")] = '\0';
            model = strchr(info, ':') + 2;
            break;
        }
    add_cell(line, model);
    if (file)
        fclose(file);
}

static const char machine_heading[] =
    ",gl_vendor,gl_renderer,gl_version,software,cpu,cores,commit,date";

/* The cells below that heading; the caller frees them. */
static char *machine_cells(void) {
    struct text cells = {0};
    char date[16];
    time_t now = time(NULL);
    add_cell(&cells, (const char *)gl.GetString(GL_VENDOR));
    add_cell(&cells, (const char *)gl.GetString(GL_RENDERER));
    add_cell(&cells, (const char *)gl.GetString(GL_VERSION));
    add_cell(&cells, gl.software ? "yes" : "no");
    add_cpu(&cells);
    strftime(date, sizeof date, "%Y-%m-%d", gmtime(&now));
    text_print(&cells, ",%d,%s,%s", parallel_core_count(), MANYLIGHT_COMMIT, date);
    return cells.data;
}

void results_print_machine(void) {
    char *cells = machine_cells();
    printf("%s\n%s%s\n", machine_heading + 1, cells + 1,
           gl.software ? " (passes timed with glFinish)" : "");
    free(cells);
}

static void add_subject(struct text *line, const struct subject *subject) {
    const struct measure_desc *desc = &subject->desc;
    char *settings = measure_settings(desc);
    add_cell(line, subject->scene);
    text_print(line, ",%u,%d,%d", subject->faces, desc->width, desc->height);
    add_cell(line, desc->technique ? desc->technique->name : "");
    add_cell(line, desc->variant);
    add_cell(line, desc->point);
    add_cell(line, settings);
    free(settings);
}

/* Empty where there is nothing to share by. */
static void add_share(struct text *line, double value, double by) {
    text_print(line, value > 0 && by > 0 ? ",%.4g" : ",", value / by);
}

static void add_row(struct text *out, const struct results *results, const struct result *row) {
    const struct subject *subject = &results->subjects[row->subject];
    const struct summary *f = &row->figure;
    double nanoseconds = strcmp(row->unit, "ms") == 0 ? 1e6 * f->value : 0;
    add_subject(out, subject);
    add_cell(out, row->what);
    add_cell(out, row->against);
    add_cell(out, row->unit);
    text_print(out, ",%.6g,%.6g,%.6g,%.6g,%.6g,%d", f->value, f->p5, f->p95, f->minimum, f->maximum,
               f->count);
    add_share(out, results_value(results, row->subject, "clock", NULL), 1);
    add_share(out, nanoseconds, measure_pixels(&subject->desc));
    add_share(out, nanoseconds, measure_pixel_vpls(&subject->desc));
}

bool results_write(const struct results *results, const char *mode, const char *path) {
    char *machine = machine_cells();
    struct text out = {0};
    text_print(&out,
               "mode,scene,faces,width,height,technique,variant,point,settings,what,against,unit,"
               "value,p5,p95,min,max,count,frame_ms,ns_per_pixel,ns_per_pixel_vpl%s\n",
               machine_heading);
    for (int i = 0; i < results->row_count; i++) {
        text_print(&out, "%s", mode);
        add_row(&out, results, &results->rows[i]);
        text_print(&out, "%s\n", machine);
    }
    bool ok = output_file_write(path, out.data, out.length);
    free(out.data);
    free(machine);
    return ok;
}
