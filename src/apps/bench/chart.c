/* manylight bench chart: draws what other modes have measured. */
#define _POSIX_C_SOURCE 200809L
#include "apps/bench/bench.h"

#include "base/error.h"
#include "base/file/file.h"
#include "base/file/folder.h"
#include "base/file/image_file.h"
#include "base/file/output_file.h"
#include "base/memory.h"

#include <dirent.h>
#include <errno.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

extern const char chart_script[]; /* bench/chart.gp */

static bool check(struct bench *bench) {
    for (int i = 0; i < bench->argument_count; i++)
        if (strpbrk(bench->arguments[i], "'\n"))
            return error_set("%s: gnuplot takes no quote in a name", bench->arguments[i]);
        else if (file_is_stream(bench->arguments[i]))
            return error_set("%s: not a file", bench->arguments[i]);
    return bench->argument_count || error_set("FILE.csv is missing");
}

/* gnuplot says nothing of a disk that takes no more: a drawing must end as it should. */
static bool is_whole(const char *path, const struct file_bytes *bytes) {
    static const char end[] = "</svg>";
    if (strcmp(strrchr(path, '.'), ".svg") != 0)
        return image_is_whole(path);
    size_t size = bytes->size;
    while (size > 0 && bytes->data[size - 1] == '\n')
        size--;
    return size > strlen(end) && memcmp(bytes->data + size - strlen(end), end, strlen(end)) == 0;
}

static bool keep(const char *drawn, const char *path) {
    struct file_bytes bytes;
    bool ok = file_read(&bytes, drawn) &&
              (is_whole(drawn, &bytes) ||
               error_set("cannot write %s: gnuplot's drawing has no end", path)) &&
              output_file_write(path, bytes.data, bytes.size);
    free(bytes.data);
    if (ok)
        printf("%s\n", path);
    return ok;
}

static int is_drawing(const struct dirent *entry) {
    return strstr(entry->d_name, ".svg") || strstr(entry->d_name, ".png");
}

/* Takes what was drawn to its folder; deletes it here, whatever happens. */
static bool take_drawings(const char *from, const char *to, bool ok) {
    struct dirent **entries;
    int count = scandir(from, &entries, is_drawing, alphasort);
    for (int i = 0; i < count; i++) {
        char *drawn = mem_printf("%s/%s", from, entries[i]->d_name);
        char *path = mem_printf("%s/%s", to, entries[i]->d_name);
        ok = ok && keep(drawn, path);
        remove(drawn);
        mem_free(drawn, path, entries[i]);
    }
    if (count >= 0)
        free(entries);
    return ok && (count > 0 || error_set("%s: gnuplot has drawn nothing there", from));
}

static bool run_gnuplot(const char *csv, const char *folder) {
    /* The script is UTF-8, of which it warns where the locale is another. */
    FILE *gnuplot = popen("LC_ALL=C.UTF-8 gnuplot -", "w");
    if (!gnuplot)
        return error_set("cannot run gnuplot");
    fprintf(gnuplot, "csv = '%s'\nfolder = '%s'\n%s", csv, folder, chart_script);
    return pclose(gnuplot) == 0 || error_set("%s: gnuplot is missing, or draws no chart", csv);
}

/* gnuplot draws into a folder of its own. */
static bool draw(const char *csv, const char *folder) {
    const char *place = getenv("TMPDIR");
    char *own = mem_printf("%s/manylight-XXXXXX", place && *place ? place : "/tmp");
    bool ok = (access(csv, R_OK) == 0 || error_set("cannot open %s", csv)) &&
              (!strpbrk(own, "'\n") || error_set("%s: gnuplot takes no quote in a name", own)) &&
              (mkdtemp(own) || error_set("cannot make folder %s: %s", own, strerror(errno)));
    if (ok) {
        ok = take_drawings(own, folder, run_gnuplot(csv, own));
        rmdir(own);
    }
    free(own);
    return ok;
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
        "draws the CSV files of sweep, curves, passes and temporal, with gnuplot\n"
        "Writes SVG and PNG per scene: time against error with the Pareto front (sweep), error\n"
        "against each setting (curves) or number of passes (passes), flicker and VALs in use\n"
        "(temporal).",
    .arguments = "FILE.csv [FILE.csv ...]",
    .options = "output",
    .check = check,
    .finish = finish,
};
