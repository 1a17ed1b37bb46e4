/* manylight bench chart: draws what other modes have measured. */
#define _POSIX_C_SOURCE 200809L
#include "apps/bench/bench.h"

#include "base/error.h"
#include "base/folder.h"
#include "base/memory.h"

#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

extern const char chart_script[]; /* bench/chart.gp */

static bool check(struct bench *bench) {
    for (int i = 0; i < bench->argument_count; i++)
        if (strpbrk(bench->arguments[i], "'\n"))
            return error_set("%s: gnuplot takes no quote in a name", bench->arguments[i]);
    return bench->argument_count || error_set("FILE.csv is missing");
}

static bool draw(const char *csv, const char *folder) {
    if (access(csv, R_OK) != 0)
        return error_set("cannot open %s", csv);
    FILE *gnuplot = popen("gnuplot -", "w");
    if (!gnuplot)
        return error_set("cannot run gnuplot");
    fprintf(gnuplot, "csv = '%s'\nfolder = '%s'\n%s", csv, folder, chart_script);
    return pclose(gnuplot) == 0 || error_set("%s: gnuplot is missing, or draws no chart", csv);
}

static bool finish(struct bench *bench) {
    const char *folder = bench->values.output ? bench->values.output : ".";
    char *inside = mem_printf("%s/.", folder);
    bool ok = folder_make_for(inside);
    signal(SIGPIPE, SIG_IGN); /* where there is no gnuplot */
    for (int i = 0; ok && i < bench->argument_count; i++)
        ok = draw(bench->arguments[i], folder);
    free(inside);
    return ok;
}

const struct bench_mode bench_chart = {
    .name = "chart",
    .help =
        "draws the CSV files of sweep, curves and temporal, with gnuplot\n"
        "Each scene as SVG and PNG: of a sweep with a reference time against error and the Pareto\n"
        "front, of curves errors against each setting, of a clip flicker and VALs in use.",
    .arguments = "FILE.csv [FILE.csv ...]",
    .options = "output",
    .check = check,
    .variants = bench_no_variants,
    .finish = finish,
};
