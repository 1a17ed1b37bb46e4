#include "measure/failures.h"

#include "base/error.h"
#include "base/file.h"
#include "base/folder.h"
#include "base/memory.h"
#include "measure/errors.h"
#include "measure/panels.h"
#include "measure/picture.h"
#include "metrics/errors.h"
#include "metrics/layer.h"
#include "metrics/metric.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* --- bounds ----------------------------------------------------------------------------------- */

bool failure_bound_read(const char *row, const struct failure_column *column, bool small,
                        struct failure_bound *bound) {
    char *path = mem_printf("src/techniques/%s/bounds.csv", column->technique);
    char *key = mem_printf("\n%s,%s,", row, column->name);
    char *text = file_read_text(path), *line = text ? strstr(text, key) : NULL;
    struct failure_bound both[2];
    bool ok = line && sscanf(line + strlen(key), "%lf,%lf,%lf,%lf", &both[0].rmse, &both[0].bias,
                             &both[1].rmse, &both[1].bias) == 4;
    if (ok)
        *bound = both[small];
    else if (text)
        error_set("%s promises nothing for %s of '%s'", path, column->name, row);
    free(text);
    free(key);
    free(path);
    return ok;
}

/* --- one row ---------------------------------------------------------------------------------- */

struct run {
    const struct failure_row *row;
    const struct failure_desc *desc;
    struct stage stage;
    struct image truth, tests[FAILURE_COLUMNS]; /* indirect layers */
};

static int count_non_finite(const struct image *image) {
    size_t count = (size_t)image->width * (size_t)image->height * (size_t)image->channel_count;
    int bad = 0;
    for (size_t i = 0; i < count; i++)
        bad += !isfinite(image->pixels[i]);
    return bad;
}

/* The largest error of a pixel. */
static void add_worst(struct results *results, const struct comparison *comparison) {
    double worst = 0;
    int at[2] = {0, 0};
    for (int y = 0; y < comparison->reference->height; y++)
        for (int x = 0; x < comparison->reference->width; x++) {
            double error = (double)absolute_error(comparison, x, y);
            if (error <= worst)
                continue;
            worst = error;
            at[0] = x, at[1] = y;
        }
    results_add(results, "worst", "", "%",
                worst > 0 ? 100 * worst / image_mean(comparison->reference, (int[]){0, 1, 2}) : 0);
    results_add(results, "worst-x", "", "", at[0]);
    results_add(results, "worst-y", "", "", at[1]);
}

/* Whether a picture that has no value but finite ones is within the bound. */
static bool add_errors(struct results *results, const struct image *test, const struct image *truth,
                       const struct failure_bound *bound) {
    struct comparison comparison = {.test = test, .reference = truth};
    double rmse = 100 * metric_measure(metric_find("relative-rmse"), &comparison, NULL);
    double bias = 100 * metric_measure(metric_find("relative-bias"), &comparison, NULL);
    results_add(results, "relative-rmse", truth_names[TRUTH_CENTERS], "%", rmse);
    results_add(results, "relative-bias", truth_names[TRUTH_CENTERS], "%", bias);
    add_worst(results, &comparison);
    return rmse <= bound->rmse && fabs(bias) <= bound->bias;
}

/* The row's settings count, whatever column and desc say. */
static bool prepare(const struct run *run, const struct failure_column *column,
                    struct measure_desc *subject) {
    const struct failure_row *row = run->row;
    *subject = measure_default(&run->stage, run->desc->width, run->desc->height,
                               context_is_software(run->desc->context));
    char *technique = mem_printf("technique=%s", column->technique);
    bool ok = measure_assign_text(subject, technique) &&
              measure_assign_text(subject, column->settings) &&
              measure_assign_text(subject, run->desc->settings) &&
              measure_assign_text(subject, row->settings);
    free(technique);
    snprintf(subject->variant, sizeof subject->variant, "%s", column->name);
    snprintf(subject->point, sizeof subject->point, "%s", row->name);
    if (row->width) {
        subject->width = row->width;
        subject->height = row->height;
    }
    return ok;
}

static bool get_truth(struct run *run, const struct measure_desc *subject) {
    struct image picture = {0};
    bool ok = run->truth.pixels || (truth_get(&run->desc->truth, subject, &picture) &&
                                    layer_extract(&run->truth, &picture, "indirect"));
    image_free(&picture);
    return ok;
}

static bool measure(struct results *results, struct run *run, int column) {
    struct measure_desc subject;
    struct failure_bound bound;
    struct image picture = {0}, *test = &run->tests[column];
    int messages = context_message_count(run->desc->context);
    if (!prepare(run, &failure_columns[column], &subject) || !get_truth(run, &subject) ||
        !failure_bound_read(run->row->name, &failure_columns[column], run->desc->small, &bound) ||
        !picture_render(&subject, &picture))
        return false;
    messages = context_message_count(run->desc->context) - messages;
    int non_finite = count_non_finite(&picture);
    results_begin(results, &subject);
    results_add(results, "messages", "", "", messages);
    results_add(results, "non-finite", "", "", non_finite);
    results_add(results, "rmse-bound", "", "%", bound.rmse);
    results_add(results, "bias-bound", "", "%", bound.bias);
    bool ok = non_finite || layer_extract(test, &picture, "indirect");
    bool holds = ok && !non_finite && add_errors(results, test, &run->truth, &bound) && !messages;
    results_add(results, "holds", "", "", holds);
    image_free(&picture);
    return ok;
}

static bool draw(const struct run *run) {
    if (!run->desc->pictures)
        return true;
    char *path = mem_printf("%s/%s.png", run->desc->pictures, run->row->name);
    bool ok = folder_make_for(path) &&
              panels_write(path, run->row->name, &run->truth, run->tests, FAILURE_COLUMNS);
    free(path);
    return ok;
}

bool failure_measure(struct results *results, const struct failure_row *row,
                     const struct failure_desc *desc) {
    struct run run = {.row = row, .desc = desc};
    bool ok =
        stage_init(&run.stage, &(struct stage_desc){.path = row->scene, .camera = row->camera});
    for (int i = 0; ok && i < FAILURE_COLUMNS; i++)
        ok = measure(results, &run, i) || error_prefix("%s", failure_columns[i].name);
    ok = ok && draw(&run);
    for (int i = 0; i < FAILURE_COLUMNS; i++)
        image_free(&run.tests[i]);
    image_free(&run.truth);
    stage_free(&run.stage);
    return ok || error_prefix("%s", row->name);
}
