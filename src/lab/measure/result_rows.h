/* Results as rows of CSV.
 *
 * The file has one shape whatever was measured, and every row tells subject and machine, so that
 * rows of many runs may be put together:
 *
 *     mode, scene, faces, width, height, technique, variant, point, settings    the subject
 *     what, against, unit, value, p5, p95, min, max, count                      the figure
 *     frame_ms                     the time of the subject's frame by the clock, where it was taken
 *     ns_per_pixel, ns_per_pixel_vpl                                            of times
 *     gl_vendor, gl_renderer, gl_version, software, cpu, cores, commit, date    the machine
 */
#ifndef LAB_MEASURE_RESULT_ROWS_H
#define LAB_MEASURE_RESULT_ROWS_H

#include "lab/measure/results.h"

/* Error: of the file. */
bool result_rows_write(const struct results *results, const char *mode, const char *path);

/* The machine of the current context, on stdout. */
void result_rows_print_machine(void);

#endif
