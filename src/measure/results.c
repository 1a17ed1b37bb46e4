#include "measure/results.h"

#include "base/memory.h"
#include "base/output_file.h"
#include "base/parallel.h"

#include "version.h"

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

static struct result *add(struct results *results, const char *what) {
    size_t count = (size_t)results->row_count++;
    results->rows = mem_resize(results->rows, count + 1, sizeof *results->rows);
    struct result *row = &results->rows[count];
    *row = (struct result){.subject = results->subject_count - 1, .against = ""};
    snprintf(row->what, sizeof row->what, "%s", what);
    return row;
}

void results_add(struct results *results, const char *what, const char *against, const char *unit,
                 double value) {
    struct result *row = add(results, what);
    row->against = against;
    row->unit = unit;
    row->figure = (struct summary){value, value, value, value, value, 1};
}

void results_add_summary(struct results *results, const char *what, const char *unit,
                         const struct summary *figure) {
    struct result *row = add(results, what);
    row->unit = unit;
    row->figure = *figure;
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

enum {
    COLUMNS_MAX = sizeof((struct table *)NULL)->columns / sizeof *((struct table *)NULL)->columns
};

/* The subject's rows of the table's columns. Returns whether there is any. */
static bool find_line(const struct results *results, int subject, const struct table *table,
                      const struct result *line[COLUMNS_MAX]) {
    bool any = false;
    for (int i = 0; i < COLUMNS_MAX && table->columns[i].heading; i++) {
        line[i] = results_find(results, subject, table->columns[i].what, table->columns[i].against);
        any = any || line[i];
    }
    return any;
}

static bool same_heading(const struct subject *a, const struct subject *b) {
    return strcmp(a->scene, b->scene) == 0 && a->faces == b->faces &&
           a->desc.width == b->desc.width && a->desc.height == b->desc.height;
}

static void print_heading(FILE *out, const struct subject *subject, const struct table *table) {
    fprintf(out, "%s: %s, %u faces, %dx%d\n  %-20s %-24s", table->title, subject->scene,
            subject->faces, subject->desc.width, subject->desc.height, "variant", "");
    for (int i = 0; i < COLUMNS_MAX && table->columns[i].heading; i++)
        fprintf(out, " %10s", table->columns[i].heading);
    fprintf(out, "\n");
}

static void print_value(FILE *out, const struct result *row) {
    if (row)
        fprintf(out, " %10.*f",
                strcmp(row->unit, "1") == 0 ? 4
                : *row->unit                ? 2
                                            : 0,
                row->figure.value);
    else
        fprintf(out, " %10s", "-");
}

void results_print(FILE *out, const struct results *results, int first, const struct table *table) {
    const struct subject *last = NULL;
    for (int i = first; i < results->subject_count; i++) {
        const struct subject *subject = &results->subjects[i];
        const struct result *line[COLUMNS_MAX];
        if (!find_line(results, i, table, line))
            continue;
        if (!last || !same_heading(last, subject))
            print_heading(out, subject, table);
        last = subject;
        fprintf(out, "  %-20s %-24s", subject->desc.variant, subject->desc.point);
        for (int k = 0; k < COLUMNS_MAX && table->columns[k].heading; k++)
            print_value(out, line[k]);
        fprintf(out, "\n");
    }
}

/* --- the machine ------------------------------------------------------------------------------ */

enum { MACHINE_CELLS = 8 };

static const char *const machine_names[MACHINE_CELLS] = {
    "gl_vendor", "gl_renderer", "gl_version", "software", "cpu", "cores", "commit", "date"};

struct machine {
    char cells[MACHINE_CELLS][160];
};

static void read_cpu(char *text, size_t size) {
    char line[256];
    snprintf(text, size, "unknown");
    FILE *file = fopen("/proc/cpuinfo", "r");
    while (file && fgets(line, sizeof line, file))
        if (strncmp(line, "model name", 10) == 0 && strchr(line, ':')) {
            snprintf(text, size, "%s", strchr(line, ':') + 2);
            break;
        }
    if (file)
        fclose(file);
    text[strcspn(text, "\n")] = '\0';
}

static struct machine machine_read(bool software) {
    static const GLenum strings[] = {GL_VENDOR, GL_RENDERER, GL_VERSION};
    struct machine machine;
    size_t size = sizeof machine.cells[0];
    time_t now = time(NULL);
    for (int i = 0; i < 3; i++)
        snprintf(machine.cells[i], size, "%s", (const char *)gl.GetString(strings[i]));
    snprintf(machine.cells[3], size, software ? "yes" : "no");
    read_cpu(machine.cells[4], size);
    snprintf(machine.cells[5], size, "%d", parallel_core_count());
    snprintf(machine.cells[6], size, "%s", MANYLIGHT_COMMIT);
    strftime(machine.cells[7], size, "%Y-%m-%d", gmtime(&now));
    return machine;
}

void results_print_machine(FILE *out, bool software) {
    struct machine machine = machine_read(software);
    for (int i = 0; i < MACHINE_CELLS; i++)
        fprintf(out, "%s%s %s", i ? ", " : "", machine_names[i], machine.cells[i]);
    fprintf(out, "%s\n", software ? " (passes timed with glFinish)" : "");
}

/* --- the file --------------------------------------------------------------------------------- */

static void print_cell(FILE *out, const char *text) {
    bool quoted = strpbrk(text, ",\"\n");
    fputs(quoted ? "\"" : "", out);
    for (const char *c = text; *c; c++)
        fprintf(out, *c == '"' ? "\"\"" : "%c", *c);
    fputs(quoted ? "\"," : ",", out);
}

static void print_subject(FILE *out, const char *mode, const struct subject *subject) {
    char *settings = measure_settings(&subject->desc);
    print_cell(out, mode);
    print_cell(out, subject->scene);
    fprintf(out, "%u,%d,%d,", subject->faces, subject->desc.width, subject->desc.height);
    print_cell(out, subject->desc.technique->name);
    print_cell(out, subject->desc.variant);
    print_cell(out, subject->desc.point);
    print_cell(out, settings);
    free(settings);
}

static void print_figure(FILE *out, const struct result *row) {
    const struct summary *f = &row->figure;
    print_cell(out, row->what);
    print_cell(out, row->against);
    print_cell(out, row->unit);
    fprintf(out, "%.6g,%.6g,%.6g,%.6g,%.6g,%d,", f->value, f->p5, f->p95, f->minimum, f->maximum,
            f->count);
}

/* Empty where there is nothing to share by. */
static void print_share(FILE *out, double value, double by) {
    if (value > 0 && by > 0)
        fprintf(out, "%.4g", value / by);
    fputc(',', out);
}

static void print_row(FILE *out, const char *mode, const struct results *results,
                      const struct result *row, const struct machine *machine) {
    const struct subject *subject = &results->subjects[row->subject];
    double nanoseconds = strcmp(row->unit, "ms") == 0 ? 1e6 * row->figure.value : 0;
    print_subject(out, mode, subject);
    print_figure(out, row);
    print_share(out, results_value(results, row->subject, "clock", NULL), 1);
    print_share(out, nanoseconds, measure_pixels(&subject->desc));
    print_share(out, nanoseconds, measure_pixel_vpls(&subject->desc));
    for (int i = 0; i < MACHINE_CELLS - 1; i++)
        print_cell(out, machine->cells[i]);
    fprintf(out, "%s\n", machine->cells[MACHINE_CELLS - 1]);
}

bool results_write(const struct results *results, const char *mode, const char *path) {
    struct machine machine =
        machine_read(results->subject_count && results->subjects[0].desc.software);
    struct output_text text;
    output_text_init(&text);
    FILE *out = text.stream;
    fprintf(out, "mode,scene,faces,width,height,technique,variant,point,settings,what,against,unit,"
                 "value,p5,p95,min,max,count,frame_ms,ns_per_pixel,ns_per_pixel_vpl");
    for (int i = 0; i < MACHINE_CELLS; i++)
        fprintf(out, ",%s", machine_names[i]);
    fprintf(out, "\n");
    for (int i = 0; i < results->row_count; i++)
        print_row(out, mode, results, &results->rows[i], &machine);
    return output_text_end(&text, path);
}
