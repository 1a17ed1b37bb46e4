#include "lab/measure/result_rows.h"

#include "base/file/output_file.h"
#include "base/memory.h"
#include "base/parallel.h"
#include "base/text.h"

#include "version.h"

#include <stdio.h>
#include <string.h>

#define MACHINE_HEADING "gl_vendor,gl_renderer,gl_version,software,cpu,cores,commit,date"

static const char heading[] =
    "mode,scene,faces,width,height,technique,variant,point,settings,what,against,unit,"
    "value,p5,p95,min,max,count,frame_ms,ns_per_pixel,ns_per_pixel_vpl," MACHINE_HEADING "\n";

static void add_cell(struct text *line, const char *cell) {
    bool quoted = strpbrk(cell, ",\"\n");
    text_print(line, quoted ? ",\"" : ",");
    for (const char *c = cell; *c; c++)
        text_print(line, *c == '"' ? "\"\"" : "%c", *c);
    text_print(line, quoted ? "\"" : "");
}

/* --- the machine ------------------------------------------------------------------------------ */

static char *cpu_name(void) {
    char info[256], *model = NULL;
    FILE *file = fopen("/proc/cpuinfo", "r");
    while (file && !model && fgets(info, sizeof info, file))
        if (strncmp(info, "model name", 10) == 0 && strchr(info, ':')) {
            info[strcspn(info, "\n")] = '\0';
            model = mem_strdup(strchr(info, ':') + 2);
        }
    if (file)
        fclose(file);
    return model ? model : mem_strdup("unknown");
}

/* Of the current context, but for the date. */
static char *machine_text(void) {
    char *cpu = cpu_name();
    struct text text = {0};
    add_cell(&text, (const char *)gl.GetString(GL_VENDOR));
    add_cell(&text, (const char *)gl.GetString(GL_RENDERER));
    add_cell(&text, (const char *)gl.GetString(GL_VERSION));
    add_cell(&text, gl.software ? "yes" : "no");
    add_cell(&text, cpu);
    text_print(&text, ",%d", parallel_core_count());
    add_cell(&text, MANYLIGHT_COMMIT);
    free(cpu);
    return text.data;
}

void result_rows_print_machine(void) {
    char *cells = machine_text(), date[16];
    results_set_date(date);
    printf("%s\n%s,%s%s\n", MACHINE_HEADING, cells + 1, date,
           gl.software ? " (passes timed with glFinish)" : "");
    free(cells);
}

/* --- rows ------------------------------------------------------------------------------------- */

/* The first cells, of mode and subject, without a comma behind them. */
static char *subject_cells(const char *mode, const struct subject *subject) {
    const struct measure_desc *desc = &subject->desc;
    char *settings = measure_settings(desc);
    struct text cells = {0};
    text_print(&cells, "%s", mode);
    add_cell(&cells, subject->scene);
    text_print(&cells, ",%u,%d,%d", subject->faces, desc->width, desc->height);
    add_cell(&cells, desc->technique ? desc->technique->name : "");
    add_cell(&cells, desc->variant);
    add_cell(&cells, desc->point);
    add_cell(&cells, settings);
    free(settings);
    return cells.data;
}

/* Empty where there is nothing to share by. */
static void add_share(struct text *line, double value, double by) {
    text_print(line, value > 0 && by > 0 ? ",%.4g" : ",", value / by);
}

static void add_figure(struct text *out, const struct results *results, const struct result *row) {
    const struct subject *subject = &results->subjects[row->subject];
    const struct summary *f = &row->figure;
    const double values[] = {f->value, f->p5, f->p95, f->minimum, f->maximum};
    double nanoseconds = strcmp(row->unit, "ms") == 0 ? 1e6 * f->value : 0;
    add_cell(out, row->what);
    add_cell(out, row->against);
    add_cell(out, row->unit);
    for (size_t i = 0; i < sizeof values / sizeof *values; i++)
        text_print(out, ",%.6g", values[i]);
    text_print(out, ",%d", f->count);
    add_share(out, results_value(results, row->subject, "clock", NULL), 1);
    add_share(out, nanoseconds, measure_pixels(&subject->desc));
    add_share(out, nanoseconds, measure_pixel_vpls(&subject->desc));
}

bool result_rows_write(const struct results *results, const char *mode, const char *path) {
    char *machine = machine_text();
    struct text out = {0};
    text_print(&out, "%s", heading);
    for (int i = 0; i < results->row_count; i++) {
        const struct result *row = &results->rows[i];
        const struct subject *subject = &results->subjects[row->subject];
        char *cells = subject_cells(mode, subject);
        text_print(&out, "%s", cells);
        add_figure(&out, results, row);
        text_print(&out, "%s,%s\n", machine, subject->date);
        free(cells);
    }
    bool ok = output_file_write(path, out.data, out.length);
    mem_free(machine, out.data);
    return ok;
}
