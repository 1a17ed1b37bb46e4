#include "lab/measure/failures.h"

#include "base/error.h"
#include "base/file/folder.h"
#include "base/file/image_file.h"
#include "base/memory.h"
#include "lab/measure/errors.h"
#include "lab/measure/variants.h"
#include "metrics/errors.h"
#include "metrics/layer.h"
#include "quality/picture.h"

#include <math.h>
#include <string.h>

/* --- bounds ----------------------------------------------------------------------------------- */

/* At most, per cent. */
struct bound {
    double rmse, bias;
};

extern const char failure_bounds[]; /* all bounds.csv, each line behind "TECHNIQUE," */

/* Error: there is no such row. */
static bool read_bound(const struct measure_desc *subject, bool small, struct bound *bound) {
    char *key =
        mem_printf("\n%s,%s,%s,", subject->technique->name, subject->point, subject->variant);
    const char *row = strstr(failure_bounds, key);
    struct bound both[2];
    bool ok = row && sscanf(row + strlen(key), "%lf,%lf,%lf,%lf", &both[0].rmse, &both[0].bias,
                            &both[1].rmse, &both[1].bias) == 4;
    free(key);
    if (!ok)
        return error_set("src/techniques/%s/bounds.csv had no row for it at the build",
                         subject->technique->name);
    *bound = both[small];
    return true;
}

/* --- one row ---------------------------------------------------------------------------------- */

struct run {
    const struct failure_row *row;
    const struct failure_desc *desc;
    struct stage stage;
    struct image picture;                           /* the reference, all layers */
    struct image reference, tests[FAILURE_COLUMNS]; /* indirect layers */
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
    for (int y = 0; y < comparison->reference->height; y++)
        for (int x = 0; x < comparison->reference->width; x++)
            worst = fmax(worst, (double)absolute_error(comparison, x, y));
    results_add(results, "worst", "", "%",
                worst > 0 ? 100 * worst / image_mean(comparison->reference, (int[]){0, 1, 2}) : 0);
}

/* The row's settings count, whatever column and desc say. */
static bool prepare(const struct run *run, const char *column, struct measure_desc *subject,
                    struct bound *bound) {
    const struct failure_row *row = run->row;
    const struct text_list *common = run->desc->settings;
    *subject = measure_default(&run->stage, row->width ? row->width : run->desc->width,
                               row->height ? row->height : run->desc->height);
    snprintf(subject->point, sizeof subject->point, "%s", row->name);
    return variant_apply(subject, column) && read_bound(subject, run->desc->small, bound) &&
           (!common || measure_assign_all(subject, common->items, common->count)) &&
           measure_assign(subject, row->settings);
}

static bool get_reference(struct run *run, const struct measure_desc *subject) {
    return run->reference.pixels || (reference_get(&run->desc->reference, subject, &run->picture) &&
                                     layer_extract(&run->reference, &run->picture, "indirect"));
}

/* Of a picture whose values are all finite. */
static bool add_errors(struct results *results, const struct run *run, const struct image *picture,
                       struct image *test) {
    if (!layer_extract(test, picture, "indirect"))
        return false;
    add_worst(results, &(struct comparison){.test = test, .reference = &run->reference});
    return errors_add(results, picture, &run->picture, reference_names[REFERENCE_CENTERS]);
}

static void add_bound(struct results *results, const struct bound *bound, bool sound) {
    int subject = results->subject_count - 1;
    results_add(results, "rmse-bound", "", "%", bound->rmse);
    results_add(results, "bias-bound", "", "%", bound->bias);
    results_add(results, "holds", "", "",
                sound && results_value(results, subject, "relative-rmse", NULL) <= bound->rmse &&
                    fabs(results_value(results, subject, "relative-bias", NULL)) <= bound->bias);
}

static bool measure(struct results *results, struct run *run, int column) {
    struct measure_desc subject;
    struct bound bound = {0};
    struct image picture = {0};
    int messages = context_message_count(run->desc->context);
    if (!prepare(run, failure_columns[column], &subject, &bound))
        return false;
    results_tell_work(results, &subject, column);
    if (!get_reference(run, &subject) || !picture_render(&subject, &picture))
        return false;
    messages = context_message_count(run->desc->context) - messages;
    int non_finite = count_non_finite(&picture);
    results_begin(results, &subject);
    results_add(results, "messages", "", "", messages);
    results_add(results, "non-finite", "", "", non_finite);
    bool ok = non_finite || add_errors(results, run, &picture, &run->tests[column]);
    add_bound(results, &bound, ok && !non_finite && !messages);
    image_free(&picture);
    return ok;
}

/* Adds a picture of three channels as a layer. */
static void add_layer(struct image *all, const char *name, const struct image *picture) {
    char *names = mem_printf("%s.R %s.G %s.B", name, name, name);
    int first = all->channel_count;
    image_add_channels(all, names);
    for (int y = 0; y < all->height; y++)
        for (int x = 0; x < all->width; x++)
            memcpy(image_at(all, x, y) + first, image_at(picture, x, y), 3 * sizeof(float));
    free(names);
}

/* The reference, and a layer for each column. */
static bool write_pictures(const struct run *run) {
    struct image all = image_copy(&run->reference);
    for (int i = 0; i < FAILURE_COLUMNS; i++)
        if (run->tests[i].pixels) {
            char *name =
                mem_printf("%.*s", (int)strcspn(failure_columns[i], ":"), failure_columns[i]);
            add_layer(&all, name, &run->tests[i]);
            free(name);
        }
    char *path = mem_printf("%s/%s.exr", run->desc->pictures, run->row->name);
    bool ok = folder_make_for(path) && image_write(&all, path);
    image_free(&all);
    free(path);
    return ok;
}

static bool is_asked(const struct run *run, int column) {
    return !run->desc->columns || run->desc->columns >> column & 1;
}

static bool measure_all(struct results *results, struct run *run) {
    bool ok = true;
    for (int i = 0; ok && i < FAILURE_COLUMNS; i++)
        ok = !is_asked(run, i) || measure(results, run, i) ||
             error_prefix("%.*s", (int)strcspn(failure_columns[i], ":"), failure_columns[i]);
    return ok && (!run->desc->pictures || write_pictures(run)) && results_commit(results);
}

bool failure_measure(struct results *results, const struct failure_row *row,
                     const struct failure_desc *desc) {
    struct run run = {.row = row, .desc = desc};
    char *scene = folder_find_own(row->scene);
    bool ok = stage_init(&run.stage, &(struct stage_desc){.path = scene, .camera = row->camera});
    free(scene);
    ok = ok && measure_all(results, &run);
    for (int i = 0; i < FAILURE_COLUMNS; i++)
        image_free(&run.tests[i]);
    images_free(&run.reference, &run.picture);
    stage_free(&run.stage);
    return ok || error_prefix("%s", row->name);
}
