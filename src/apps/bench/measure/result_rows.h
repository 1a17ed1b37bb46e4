/* Results as rows of CSV.
 *
 * The file has one shape whatever was measured, and every row tells subject and machine, so that rows of many runs may be
 * put together:
 *
 *     mode, scene, faces, width, height, technique, variant, point, settings    the subject
 *     what, against, unit, value, p5, p95, min, max, count                      the figure
 *     frame_ms                     the time of the subject's frame by the clock, where it was taken
 *     ns_per_pixel, ns_per_pixel_vpl                                            of times
 *     gl_vendor, gl_renderer, gl_version, software, cpu, cores, commit, date    the machine
 */
#ifndef APPS_BENCH_MEASURE_RESULT_ROWS_H
#define APPS_BENCH_MEASURE_RESULT_ROWS_H

#include "apps/bench/measure/results.h"
#include "base/text.h"

/* The names of the columns, a line. */
extern const char result_rows_heading[];

enum { RESULT_CELLS = 29, RESULT_SUBJECT_CELLS = 9, RESULT_FIGURE_DIGITS = 6 };

/* The first cells, of mode and subject, without a comma behind them; the caller frees them. */
char *result_rows_subject(const char *mode, const struct subject *subject);

/* Rows of all subjects from the first on; figures have so many digits. */
void result_rows_add(struct text *out, const struct results *results, const char *mode, int first,
                     int digits);

/* Error: of the file. */
bool result_rows_write(const struct results *results, const char *mode, const char *path);

/* The cells that tell the machine, of the current context, but for the date: a name and a value each, until one has no
 * name; the caller frees the values. */
struct machine_cell {
    const char *name;
    char *value;
};
enum { MACHINE_CELLS = 7 };
void machine_cells_init(struct machine_cell cells[MACHINE_CELLS + 1]);
void machine_cells_free(struct machine_cell cells[MACHINE_CELLS + 1]);

/* On stdout. */
void result_rows_print_machine(void);

#endif
