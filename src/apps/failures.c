#include "apps/failures.h"

#include "apps/bench_picture.h"
#include "apps/failure_picture.h"

#include "base/error.h"
#include "base/folder.h"
#include "base/memory.h"
#include "base/output_file.h"
#include "metrics/errors.h"
#include "metrics/layer.h"
#include "metrics/metric.h"

#include "version.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Of the part before the colon. */
static int name_length(int technique) {
    return (int)strcspn(failure_techniques[technique], ":");
}

/* --- one row ---------------------------------------------------------------------------------- */

static int count_non_finite(const struct image *image) {
    size_t count = (size_t)image->width * (size_t)image->height * (size_t)image->channel_count;
    int bad = 0;
    for (size_t i = 0; i < count; i++)
        bad += !isfinite(image->pixels[i]);
    return bad;
}

/* The largest error of a pixel, over the reference's mean. */
static void find_worst(const struct comparison *comparison, struct failure_result *result) {
    const struct image *reference = comparison->reference;
    double mean = 0;
    for (int y = 0; y < reference->height; y++)
        for (int x = 0; x < reference->width; x++) {
            const float *r = image_at(reference, x, y);
            double error = (double)absolute_error(comparison, x, y);
            mean += (double)(r[0] + r[1] + r[2]) / 3;
            if (error <= result->worst)
                continue;
            result->worst = error;
            result->worst_x = x;
            result->worst_y = y;
        }
    mean /= (double)reference->width * reference->height;
    result->worst = result->worst > 0 ? result->worst / mean : 0;
}

static void compare(const struct image *test, const struct image *reference,
                    struct failure_result *result) {
    struct comparison comparison = {.test = test, .reference = reference};
    result->relative_rmse = metric_measure(metric_find("relative-rmse"), &comparison, NULL);
    result->relative_bias = metric_measure(metric_find("relative-bias"), &comparison, NULL);
    find_worst(&comparison, result);
}

struct row_run {
    const struct failure_row *row;
    const struct bench_values *values;
    const struct context *context;
    struct stage stage;
    struct image truth, tests[FAILURE_TECHNIQUES]; /* indirect layers */
};

static bool get_truth(struct row_run *run, const struct bench_case *prepared) {
    struct image picture = {0};
    bool ok =
        bench_reference_get(&(struct bench_reference_desc){.kind = BENCH_REFERENCE_CENTERS,
                                                           .cache = run->values->cache,
                                                           .scene_path = run->row->scene,
                                                           .stage = &run->stage,
                                                           .width = prepared->width,
                                                           .height = prepared->height,
                                                           .noise = (double)run->values->noise},
                            &picture) &&
        layer_extract(&run->truth, &picture, "indirect");
    image_free(&picture);
    return ok;
}

/* The row's settings count, whatever the technique and the command line say. */
static bool prepare(const struct row_run *run, int technique, struct bench_case *prepared) {
    const struct failure_row *row = run->row;
    if (!bench_prepare(prepared, run->values, &run->stage, failure_techniques[technique]) ||
        (row->settings && !bench_assign_all(prepared, row->settings)))
        return false;
    if (row->width) {
        prepared->width = row->width;
        prepared->height = row->height;
    }
    return true;
}

static bool measure(struct row_run *run, int technique, struct failure_result *result) {
    struct bench_case prepared;
    struct image picture;
    int messages = context_message_count(run->context);
    *result = (struct failure_result){0};
    if (!prepare(run, technique, &prepared) || (technique == 0 && !get_truth(run, &prepared)))
        return false;
    bool ok =
        bench_picture_render(&prepared, &run->stage, context_is_software(run->context), &picture);
    result->messages = context_message_count(run->context) - messages;
    result->non_finite = ok ? count_non_finite(&picture) : 0;
    if (ok && result->non_finite == 0) {
        ok = layer_extract(&run->tests[technique], &picture, "indirect");
        if (ok)
            compare(&run->tests[technique], &run->truth, result);
    }
    image_free(&picture);
    return ok;
}

/* A technique whose picture is not finite has an empty panel. */
static bool draw(struct row_run *run) {
    if (!run->values->output)
        return true;
    for (int t = 0; t < FAILURE_TECHNIQUES; t++)
        if (!run->tests[t].pixels)
            image_init(&run->tests[t], run->truth.width, run->truth.height, "R G B");
    char *path = mem_printf("%s/%s.png", run->values->output, run->row->name);
    bool ok = folder_make_for(path) &&
              failure_picture_write(&(struct failure_picture){.reference = &run->truth,
                                                              .tests = run->tests,
                                                              .test_count = FAILURE_TECHNIQUES,
                                                              .title = run->row->name},
                                    path);
    free(path);
    return ok;
}

bool failure_measure(const struct failure_row *row, const struct bench_values *values,
                     const struct context *context, struct failure_result *results) {
    struct row_run run = {.row = row, .values = values, .context = context};
    bool ok = stage_init(
        &run.stage,
        &(struct stage_desc){.path = row->scene, .camera = row->camera, .light = row->light});
    for (int t = 0; ok && t < FAILURE_TECHNIQUES; t++)
        ok = measure(&run, t, &results[t]) ||
             error_prefix("%.*s", name_length(t), failure_techniques[t]);
    ok = ok && draw(&run);
    for (int t = 0; t < FAILURE_TECHNIQUES; t++)
        image_free(&run.tests[t]);
    image_free(&run.truth);
    stage_free(&run.stage);
    return ok || error_prefix("%s", row->name);
}

bool failure_holds(const struct failure_row *row, int technique,
                   const struct failure_result *result, double slack) {
    double bound = row->bounds[technique] / 100;
    return result->non_finite == 0 && result->messages == 0 &&
           (bound == 0 || result->relative_rmse <= slack * bound);
}

/* --- the suite -------------------------------------------------------------------------------- */

static void print_head(void) {
    printf("%-18s", "");
    for (int t = 0; t < FAILURE_TECHNIQUES; t++)
        printf("  %-24.*s", name_length(t), failure_techniques[t]);
    printf("\n%-18s", "per cent");
    for (int t = 0; t < FAILURE_TECHNIQUES; t++)
        printf("  %7s %7s %8s", "rRMSE", "bias", "worst");
    printf("\n");
}

static void print_row(const struct failure_row *row, const struct failure_result *results) {
    printf("%-18s", row->name);
    for (int t = 0; t < FAILURE_TECHNIQUES; t++) {
        const struct failure_result *result = &results[t];
        printf("  %7.2f%s%+7.2f %8.1f", 100 * result->relative_rmse,
               failure_holds(row, t, result, 1) ? " " : "!", 100 * result->relative_bias,
               100 * result->worst);
        if (result->non_finite || result->messages)
            printf(" (%d not finite, %d messages)", result->non_finite, result->messages);
    }
    printf("\n");
    fflush(stdout);
}

static void write_row(FILE *csv, const struct failure_row *row,
                      const struct failure_result *results) {
    for (int t = 0; t < FAILURE_TECHNIQUES; t++)
        fprintf(csv, "%s,%.*s,\"%s\",%.5g,%.5g,%.5g,%d,%d,%d,%d,%.4g,%s\n", row->name,
                name_length(t), failure_techniques[t], row->settings ? row->settings : "",
                results[t].relative_rmse, results[t].relative_bias, results[t].worst,
                results[t].worst_x, results[t].worst_y, results[t].non_finite, results[t].messages,
                row->bounds[t] / 100, MANYLIGHT_COMMIT);
}

/* Prints and writes one row; counts what does not hold. */
static bool run_row(const struct failure_row *row, const struct bench_values *values,
                    const struct context *context, struct output_text *csv, int *broken) {
    struct failure_result results[FAILURE_TECHNIQUES];
    if (!failure_measure(row, values, context, results))
        return false;
    print_row(row, results);
    write_row(csv->stream, row, results);
    for (int t = 0; t < FAILURE_TECHNIQUES; t++)
        *broken += !failure_holds(row, t, &results[t], 1);
    return !values->csv || output_text_write(csv, values->csv);
}

static bool run_rows(const struct bench_values *values, const char **names, int name_count,
                     const struct context *context, struct output_text *csv, int *broken) {
    print_head();
    int count = name_count ? name_count : failure_row_count;
    for (int i = 0; i < count; i++) {
        const struct failure_row *row = name_count ? failure_row_find(names[i]) : &failure_rows[i];
        if (!row || !run_row(row, values, context, csv, broken))
            return false;
    }
    return true;
}

bool bench_failures(const struct bench_values *values, const char **names, int name_count,
                    const struct context *context) {
    struct output_text csv;
    int broken = 0;
    output_text_init(&csv);
    fprintf(csv.stream, "failure,technique,settings,relative_rmse,relative_bias,worst,worst_x,"
                        "worst_y,non_finite,messages,bound,commit\n");
    bool ok = run_rows(values, names, name_count, context, &csv, &broken);
    output_text_free(&csv);
    if (ok && broken)
        ok = error_set("%d results are not what is promised (!)", broken);
    return ok;
}
