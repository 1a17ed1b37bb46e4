/* manylight score: the errors of a folder of pictures, whoever made them, and faults that make such
 * errors meaningless. */
#include "apps/arguments.h"
#include "apps/outputs.h"
#include "apps/subcommands.h"
#include "lab/measure/reference.h"
#include "lab/score/entry.h"
#include "lab/score/method.h"

#include "base/error.h"
#include "base/file/image_file.h"
#include "base/file/output_file.h"
#include "base/json.h"
#include "base/memory.h"
#include "lab/score/faults.h"
#include "lab/score/sha256.h"
#include "metrics/layer.h"
#include "metrics/metric.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

struct values {
    struct common_values common;
    struct text_list scenes;
    const char *output;
};

static const struct option options[] = {
    {"scene", 0, OPTION_LIST, offsetof(struct values, scenes), .value_name = "NAME",
     .help = "score this scene alone; repeatable [all of REFERENCES]"},
    {"output", 'o', OPTION_TEXT, offsetof(struct values, output), .value_name = "FILE.json",
     .help = "write the scores as JSON; -: to standard output, and the table to standard error;\n"
             "bench/schema/score.schema.json tells their form"},
    {NULL},
};

static const char *const metric_names[] = {"relative-rmse", "mrse", "smape", "hdr-flip",
                                           "relative-bias"};
enum { SCORED = sizeof metric_names / sizeof *metric_names };

static void print_more(FILE *out, const void *values) {
    (void)values;
    fprintf(out,
            "\nENTRY holds method.json and pictures named SCENE.WxH.exr, of a frame of a clip\n"
            "SCENE.WxH.FRAME.exr. REFERENCES holds pictures of the same names. The beauty layer\n"
            "is scored, and the layers that method.json lists. method.json has a name, and may\n"
            "have version, url, licence, device, driver, layers, ms {median, p99, frames,\n"
            "covers}, history_frames, denoiser, hardware_rays, precomputed_s, sha256 {FILE:\n"
            "DIGITS, ...}; null is unknown.\n"
            "Metrics: as manylight compare has them. Noise: the reference's standard error of\n"
            "the indirect layer over its mean.\n"
            "Faults: name, missing-picture, no-reference, size, missing-layer, not-finite,\n"
            "sha256");
    for (int i = 0; i < FAULT_COUNT; i++)
        fprintf(out, ", %s", picture_fault_names[i]);
    fprintf(out, ".\nExit status: 0; 1 where a fault is found; 2 for wrong usage.\n");
}

static const struct arguments arguments = {
    .synopsis = "ENTRY REFERENCES [OPTION ...]",
    .summary = "Scores the pictures of a renderer against references, and names faults such as a\n"
               "wrong exposure or camera. ENTRY and REFERENCES are folders.",
    .options = options,
    .min_positional = 2,
    .max_positional = 2,
    .print_more = print_more,
};

/* What is found goes to a table and to JSON at once. */
struct score {
    FILE *table;
    const char *entry_folder, *reference_folder;
    struct method method;
    struct output_text text;
    struct json json; /* into text */
    int fault_count;
};

/* A row in the making. */
struct row {
    const char *file, *layer;
};

static void begin_row(struct score *score, struct row *row, const char *file, const char *layer) {
    *row = (struct row){file, layer};
    json_open(&score->json, NULL, "{");
    json_text(&score->json, "picture", file);
    json_text(&score->json, "layer", layer);
}

static void add_fault(struct score *score, const struct row *row, const char *fault,
                      const char *text) {
    fprintf(score->table, "%-28s %-10s fault: %s: %s\n", row->file, row->layer, fault, text);
    json_open(&score->json, NULL, "{");
    json_text(&score->json, "fault", fault);
    json_text(&score->json, "text", text);
    json_close(&score->json, "}");
    score->fault_count++;
}

static void end_row(struct score *score) {
    json_close(&score->json, "]");
    json_close(&score->json, "}");
}

/* A row that has no scores. */
static void add_unscored(struct score *score, const char *file, const char *layer,
                         const char *fault, const char *text) {
    struct row row;
    begin_row(score, &row, file, layer);
    json_text(&score->json, "metrics", NULL);
    json_text(&score->json, "noise", NULL);
    json_open(&score->json, "faults", "[");
    add_fault(score, &row, fault, text);
    end_row(score);
}

/* --- one picture ------------------------------------------------------------------------------ */

/* Both as the metrics take them. */
struct pair {
    struct image picture, reference;
    int not_finite;                 /* values of the picture that are taken as 0 */
    double noise;                   /* of the reference; NaN: it does not tell */
    char digits[SHA256_DIGITS + 1]; /* of the picture's file */
};

/* Linear R G B of a layer, with zeros for what is not finite. */
static bool read_picture(struct pair *pair, const char *path, const char *layer) {
    struct image file;
    int channels[3];
    if (!image_read_layer(&file, path, layer, channels))
        return false;
    for (int i = 0; i < file.width * file.height; i++)
        for (int c = 0; c < 3; c++) {
            float *value = &file.pixels[i * file.channel_count + channels[c]];
            pair->not_finite += !isfinite(*value);
            *value = isfinite(*value) ? *value : 0;
        }
    bool ok = layer_extract(&pair->picture, &file, layer);
    image_free(&file);
    return ok;
}

static bool read_reference(struct pair *pair, const char *path, const char *layer) {
    struct image file;
    if (!image_read(&file, path))
        return false;
    bool ok = layer_extract(&pair->reference, &file, layer) || error_prefix("%s", path);
    double noise = reference_noise(&file);
    pair->noise = noise > 0 ? noise : NAN;
    image_free(&file);
    return ok;
}

static void print_metrics(struct score *score, const struct row *row, const struct pair *pair) {
    struct comparison comparison = {.test = &pair->picture,
                                    .reference = &pair->reference,
                                    .pixels_per_degree = (float)DEFAULT_PIXELS_PER_DEGREE};
    fprintf(score->table, "%-28s %-10s", row->file, row->layer);
    json_open(&score->json, "metrics", "{");
    for (int i = 0; i < SCORED; i++) {
        double value = metric_measure(metric_find(metric_names[i]), &comparison, NULL);
        fprintf(score->table, " %13.6g", value);
        json_number(&score->json, metric_names[i], value);
    }
    if (isfinite(pair->noise))
        fprintf(score->table, " %13.6g\n", pair->noise);
    else
        fprintf(score->table, " %13s\n", "-");
    json_close(&score->json, "}");
    json_number(&score->json, "noise", pair->noise);
}

/* Of a picture that is another than method.json lists. */
static void add_sum_fault(struct score *score, struct row *row, const struct pair *pair) {
    const char *listed = method_sum_of(&score->method, row->file);
    if (!listed || strcmp(listed, pair->digits) == 0)
        return;
    char *text = mem_printf("its SHA-256 is %s, method.json lists %s", pair->digits, listed);
    add_fault(score, row, "sha256", text);
    free(text);
}

static void print_faults(struct score *score, struct row *row, const struct pair *pair) {
    struct picture_faults faults;
    json_open(&score->json, "faults", "[");
    add_sum_fault(score, row, pair);
    if (pair->not_finite) {
        char *text = mem_printf("%d values are NaN or infinite, and taken as 0", pair->not_finite);
        add_fault(score, row, "not-finite", text);
        free(text);
    }
    picture_faults_find(&pair->picture, &pair->reference, &faults);
    for (int i = 0; i < FAULT_COUNT; i++)
        if (faults.found[i]) {
            char *text = picture_fault_describe(&faults, (enum picture_fault)i);
            add_fault(score, row, picture_fault_names[i], text);
            free(text);
        }
    end_row(score);
}

static void score_pair(struct score *score, const char *file, const char *layer,
                       const struct pair *pair) {
    const struct image *picture = &pair->picture, *reference = &pair->reference;
    if (picture->width != reference->width || picture->height != reference->height) {
        char *text = mem_printf("it is %dx%d, the reference %dx%d", picture->width, picture->height,
                                reference->width, reference->height);
        add_unscored(score, file, layer, "size", text);
        free(text);
        return;
    }
    struct row row;
    begin_row(score, &row, file, layer);
    print_metrics(score, &row, pair);
    print_faults(score, &row, pair);
}

/* Error: of the reference, and of a picture that is no picture. */
static bool score_layer(struct score *score, const char *file, const char *layer) {
    struct pair pair = {0};
    char *path = mem_printf("%s/%s", score->entry_folder, file);
    char *reference_path = mem_printf("%s/%s", score->reference_folder, file);
    bool ok = image_is_whole(path) && sha256_of_file(path, pair.digits) &&
              read_reference(&pair, reference_path, layer);
    if (ok && read_picture(&pair, path, layer))
        score_pair(score, file, layer, &pair);
    else if (ok)
        add_unscored(score, file, layer, "missing-layer", error_get());
    images_free(&pair.picture, &pair.reference);
    mem_free(path, reference_path);
    return ok;
}

/* --- all of them ------------------------------------------------------------------------------ */

static bool is_asked(const struct text_list *scenes, const char *scene) {
    for (int i = 0; i < scenes->count; i++)
        if (strcmp(scenes->items[i], scene) == 0)
            return true;
    return scenes->count == 0;
}

static bool score_file(struct score *score, const char *file) {
    bool ok = score_layer(score, file, "beauty");
    for (int i = 0; ok && i < score->method.layer_count; i++)
        ok = score_layer(score, file, score->method.layers[i]);
    return ok;
}

/* Whatever its name is. */
static bool entry_has(const struct entry *entry, const char *file) {
    bool found = entry_find(entry, file);
    for (int i = 0; i < entry->other_count; i++)
        found |= strcmp(entry->others[i], file) == 0;
    return found;
}

static bool score_all(struct score *score, const struct values *values, const struct entry *entry,
                      const struct entry *references) {
    for (int i = 0; i < references->count; i++) {
        const struct entry_picture *reference = &references->pictures[i];
        if (!is_asked(&values->scenes, reference->scene))
            continue;
        if (!entry_find(entry, reference->file))
            add_unscored(score, reference->file, "beauty", "missing-picture",
                         "the entry has none of that name");
        else if (!score_file(score, reference->file))
            return false;
    }
    for (int i = 0; i < entry->count; i++)
        if (!entry_find(references, entry->pictures[i].file) &&
            is_asked(&values->scenes, entry->pictures[i].scene))
            add_unscored(score, entry->pictures[i].file, "beauty", "no-reference",
                         "REFERENCES has none of that name");
    for (int i = 0; i < score->method.sum_count && values->scenes.count == 0; i++)
        if (!entry_has(entry, score->method.sums[i].file) &&
            !entry_find(references, score->method.sums[i].file))
            add_unscored(score, score->method.sums[i].file, "beauty", "missing-picture",
                         "method.json lists its SHA-256");
    for (int i = 0; i < entry->other_count; i++)
        add_unscored(score, entry->others[i], "beauty", "name",
                     "it is neither SCENE.WxH.exr nor SCENE.WxH.FRAME.exr");
    return true;
}

static bool check_scenes(const struct text_list *scenes, const struct entry *references) {
    for (int i = 0; i < scenes->count; i++) {
        bool found = false;
        for (int j = 0; j < references->count; j++)
            found |= strcmp(references->pictures[j].scene, scenes->items[i]) == 0;
        if (!found)
            return error_set("scene: REFERENCES has no picture of '%s'", scenes->items[i]);
    }
    return references->count > 0 || error_set("REFERENCES has no picture named SCENE.WxH.exr");
}

static char **list_paths(char **to, const struct entry *entry, const char *folder) {
    for (int i = 0; i < entry->count; i++)
        *to++ = mem_printf("%s/%s", folder, entry->pictures[i].file);
    for (int i = 0; i < entry->other_count; i++)
        *to++ = mem_printf("%s/%s", folder, entry->others[i]);
    return to;
}

/* The scores take the place of no file that they are made from. */
static bool check_output(const struct score *score, const char *output, const struct entry *entry,
                         const struct entry *references) {
    int room = 1 + entry->count + entry->other_count + references->count + references->other_count;
    char **inputs = mem_alloc((size_t)room, sizeof *inputs), **end = inputs;
    *end++ = mem_printf("%s/method.json", score->entry_folder);
    end = list_paths(end, entry, score->entry_folder);
    end = list_paths(end, references, score->reference_folder);
    bool ok = output_file_check(output, (const char *const *)inputs, (int)(end - inputs));
    while (end > inputs)
        free(*--end);
    free(inputs);
    return ok;
}

static void print_head(struct score *score) {
    const struct method *method = &score->method;
    fprintf(score->table, "%s%s%s%s%s\n%-28s %-10s", method->name, *method->version ? " " : "",
            method->version, *method->device ? ", " : "", method->device, "picture", "layer");
    for (int i = 0; i < SCORED; i++)
        fprintf(score->table, " %13s", metric_names[i]);
    fprintf(score->table, " %13s\n", "noise");
    json_open(&score->json, NULL, "{");
    json_value(&score->json, "method", method->json);
    json_open(&score->json, "scores", "[");
}

static bool score_entry(struct score *score, const struct values *values) {
    struct entry entry = {0}, references = {0};
    char *path = mem_printf("%s/method.json", score->entry_folder);
    bool ok = method_read(&score->method, path) && entry_list(&entry, score->entry_folder) &&
              entry_list(&references, score->reference_folder) &&
              check_scenes(&values->scenes, &references) &&
              (!values->output || check_output(score, values->output, &entry, &references));
    output_text_init(&score->text);
    score->json = (struct json){.out = score->text.stream, .lines = 2};
    if (ok) {
        print_head(score);
        ok = score_all(score, values, &entry, &references);
        json_close(&score->json, "]");
        json_close(&score->json, "}");
    }
    ok = ok && (!values->output || output_text_write(&score->text, values->output));
    output_text_free(&score->text);
    method_free(&score->method);
    entry_free(&entry);
    entry_free(&references);
    free(path);
    return ok;
}

int app_score(int argc, char **argv) {
    struct values values = {0};
    const char *folders[2];
    int count, status;
    if (!arguments_parse(&arguments, &values, argc, argv, folders, &count, &status))
        return status;
    struct score score = {.table = outputs_table_stream(&values.output, 1),
                          .entry_folder = folders[0],
                          .reference_folder = folders[1]};
    if (!score_entry(&score, &values))
        return arguments_fail(argv[0]);
    return score.fault_count ? STATUS_FAILED : STATUS_OK;
}
