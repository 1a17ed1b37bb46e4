/* Speed against accuracy, from the rows that a sweep has written. */
#ifndef APPS_BENCH_CHART_H
#define APPS_BENCH_CHART_H

#include "apps/bench_plot.h"

/* One chart for each scene of the file that has times and errors: FOLDER/SCENE.svg and .png. Error:
 * of the file, no such scene, or gnuplot. */
bool bench_chart(const char *csv_path, const char *folder);

/* The points that no other is both as fast and as true as, by x; the caller frees them. */
struct plot_series plot_pareto_front(const struct plot *plot);

#endif
