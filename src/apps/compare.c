/* manylight compare: error metrics between two pictures, a picture of the error, and an exit status
 * over a threshold. */
#include "apps/arguments.h"
#include "apps/outputs.h"
#include "apps/subcommands.h"

#include "base/error.h"
#include "base/file/image_file.h"
#include "base/file/output_file.h"
#include "base/json.h"
#include "base/memory.h"
#include "metrics/flip/hdr_flip.h"
#include "metrics/heat_map.h"
#include "metrics/layer.h"
#include "metrics/metric.h"

#include <math.h>
#include <string.h>

struct values {
    struct common_values common;
    const char *layer, *reference_layer, *output, *format, *exposures;
    struct text_list metrics, bounds;
    float pixels_per_degree, top;
    bool json;
};

static const struct option options[] = {
    {"layer", 'l', OPTION_TEXT, offsetof(struct values, layer), .value_name = "NAME",
     .help = "layer to compare, for example indirect; see below [beauty]"},
    {"reference-layer", 0, OPTION_TEXT, offsetof(struct values, reference_layer),
     .value_name = "NAME", .help = "layer of REFERENCE, if its name differs"},
    {"metric", 'm', OPTION_LIST, offsetof(struct values, metrics), .value_name = "NAME",
     .help = "metric to measure, or \"all\"; repeatable [see below]"},
    {"max", 0, OPTION_LIST, offsetof(struct values, bounds), .value_name = "METRIC=VALUE",
     .help = "limit of a metric's absolute value, 10% is .1; exit status 1 above it; repeatable"},
    {"output", 'o', OPTION_TEXT, offsetof(struct values, output), .value_name = "FILE",
     .help = "picture of the error: false colours (PNG ...) or values (EXR ...)"},
    FORMAT_OPTION(struct values, format),
    {"top", 0, OPTION_FLOAT, offsetof(struct values, top), 0, 0, 1e9,
     .help = "error at the end of the picture's colour scale; 0: from the errors"},
    {"ppd", 0, OPTION_FLOAT, offsetof(struct values, pixels_per_degree), DEFAULT_PIXELS_PER_DEGREE,
     1, 1000, .help = "pixels per degree of the viewer, for FLIP"},
    {"exposures", 0, OPTION_TEXT, offsetof(struct values, exposures), .value_name = "START,STOP,N",
     .help = "exposures of HDR-FLIP: N from START to STOP, in EV [from REFERENCE]"},
    {"json", 0, OPTION_FLAG, offsetof(struct values, json),
     .help = "print JSON; values that are not finite become null"},
    {NULL},
};

static void print_metrics(FILE *out, const void *values) {
    (void)values;
    fprintf(out,
            "\nMetrics of v = TEST and r = REFERENCE, over pixels and R, G, B in linear light:\n");
    for (const struct metric *m = metrics; m < metrics + METRIC_COUNT; m++)
        fprintf(out, "  %-14s %s%s%s\n", m->name, m->help,
                m->usual_for & METRIC_HDR ? " [float]" : "",
                m->usual_for & METRIC_LDR ? " [integer]" : "");
    fprintf(
        out,
        "\nWithout --metric: those marked [float] where both files store floats (EXR, PFM ...),\n"
        "those marked [integer] where either stores integers (PNG, JPEG ...). Integers are\n"
        "taken as sRGB and decoded to linear light first. Alpha is ignored. NaN and infinity\n"
        "are errors. The picture shows the first --metric, or else FLIP.\n"
        "\nA layer is R G B or X Y Z of one name, or one channel alone, which is compared as "
        "grey.\n"
        "NAME is a layer (ViewLayer.Combined), the end of one (Combined), a part of an EXR, or a\n"
        "channel (Z, normal.X). Without it: R G B without a layer's name, else the layer or part\n"
        "named beauty, rgba, Combined or alike, else the first part with R G B; a note tells.\n"
        "Pictures are compared by their display windows, black where an EXR's data window has no\n"
        "pixels. They stand upright as a .hdr or a tag of a JPEG, PNG or TIFF says.\n"
        "Exit status: 0; 1 over a --max or where files do not compare; 2 for wrong usage.\n");
}

static const struct arguments arguments = {
    .synopsis = "TEST REFERENCE [OPTION ...]",
    .summary =
        "Measures the difference of picture TEST from picture REFERENCE. One of them may be -,\n"
        "standard input. With -o - the table goes to standard error.",
    .options = options,
    .min_positional = 2,
    .max_positional = 2,
    .print_more = print_metrics,
};

/* What is asked about a metric, and what came out. */
struct measurement {
    bool asked;
    double bound; /* infinite = none */
    double value;
};

struct report {
    struct measurement measurements[METRIC_COUNT]; /* as in metrics[] */
    const struct metric *pictured;                 /* by --output */
    struct exposure_range exposures;               /* of hdr-flip */
};

/* --metric: by name. */
static bool ask_named(struct report *report, const struct text_list *names) {
    for (int i = 0; i < names->count; i++) {
        bool all = strcmp(names->items[i], "all") == 0;
        const struct metric *metric = all ? NULL : metric_find(names->items[i]);
        if (!all && !metric)
            return error_prefix("metric");
        for (int m = 0; m < METRIC_COUNT; m++)
            if (all || metric == &metrics[m])
                report->measurements[m].asked = true;
        if (!report->pictured)
            report->pictured = metric;
    }
    return true;
}

/* --max: METRIC=VALUE asks for the metric too. */
static bool ask_bounded(struct report *report, const char *text) {
    char name[32];
    const char *equals = strchr(text, '=');
    snprintf(name, sizeof name, "%.*s", equals ? (int)(equals - text) : 0, text);
    if (!equals)
        return error_set("'%s' is not METRIC=VALUE", text);
    const struct metric *metric = metric_find(name);
    if (!metric)
        return false;
    if (metric->higher_is_better)
        return error_set("%s has no upper bound, for higher is better", name);
    char *end;
    double bound = strtod(equals + 1, &end);
    bool is_percent = end != equals + 1 && strcmp(end, "%") == 0;
    if (end == equals + 1 || (*end && !is_percent) || !(bound >= 0))
        return error_set("'%s' is not a number from 0 up", equals + 1);
    bound = is_percent ? bound / 100 : bound;
    report->measurements[metric - metrics] = (struct measurement){.asked = true, .bound = bound};
    return true;
}

static bool asks_hdr_flip(const struct report *report) {
    return report->measurements[metric_find("hdr-flip") - metrics].asked;
}

/* --exposures. */
static bool choose_exposures(struct exposure_range *range, const char *text) {
    const float most = 120; /* a float has no more */
    int end = 0;
    bool ok = sscanf(text, "%f,%f,%d%n", &range->first, &range->last, &range->count, &end) == 3 &&
              text[end] == '\0' && range->first >= -most && range->first <= range->last &&
              range->last <= most && range->count >= 1 && range->count <= 1000;
    return ok ||
           error_set("exposures: '%s' is not START,STOP,N with START up to STOP, both from -120 "
                     "to 120, and N from 1 to 1000",
                     text);
}

/* What an option needs to have an effect. */
static bool check_use(const struct report *report, const struct values *values, bool is_picture) {
    bool has_flip = values->metrics.count == 0, has_hdr_flip = has_flip || asks_hdr_flip(report);
    for (int i = 0; i < METRIC_COUNT; i++)
        has_flip |= report->measurements[i].asked && strstr(metrics[i].name, "flip");
    return arguments_check_use(
        &values->common,
        (struct option_use[]){{"ppd", has_flip, "hdr-flip and ldr-flip"},
                              {"exposures", has_hdr_flip, "hdr-flip"},
                              {"top", is_picture, "a picture in false colours: -o FILE.png"},
                              {NULL}});
}

/* Everything that the arguments alone can get wrong. */
static bool report_init(struct report *report, const struct values *values) {
    *report = (struct report){0};
    for (int i = 0; i < METRIC_COUNT; i++)
        report->measurements[i].bound = INFINITY;
    if (!ask_named(report, &values->metrics))
        return false;
    for (int i = 0; i < values->bounds.count; i++)
        if (!ask_bounded(report, values->bounds.items[i]))
            return error_prefix("max");
    if (values->exposures && !choose_exposures(&report->exposures, values->exposures))
        return false;
    bool is_float = true;
    if (!outputs_use_format(&values->output, 1, values->format))
        return false;
    if (values->output && !image_format_is_float(values->output, &is_float))
        return false;
    if (values->output && report->pictured && report->pictured->higher_is_better)
        return error_set("%s has no picture; put another --metric first", report->pictured->name);
    return check_use(report, values, !is_float);
}

/* The two layers, linear, and whether either file stores integers. */
struct pictures {
    const char *test_path, *reference_path;
    struct image test, reference;
    bool any_encoded;
};

/* " (data window 20x16 at 8,4)" where that is not the whole picture. */
static void describe_window(const struct image *image, char *text, size_t size) {
    const struct image_window *display = &image->display, *data = &image->data;
    snprintf(text, size, " (data window %dx%d at %d,%d, display window at %d,%d)", data->width,
             data->height, data->x, data->y, display->x, display->y);
    if (memcmp(display, data, sizeof *data) == 0)
        *text = '\0';
}

static bool check_sizes(const struct pictures *pictures) {
    char of_test[160], of_reference[160];
    const struct image *test = &pictures->test, *reference = &pictures->reference;
    if (test->width == reference->width && test->height == reference->height)
        return true;
    describe_window(test, of_test, sizeof of_test);
    describe_window(reference, of_reference, sizeof of_reference);
    return error_set("%s is %dx%d%s, but %s is %dx%d%s", pictures->test_path, test->width,
                     test->height, of_test, pictures->reference_path, reference->width,
                     reference->height, of_reference);
}

static bool pictures_read(struct pictures *pictures, const struct values *values) {
    bool test_encoded, reference_encoded;
    const char *layer = values->layer ? values->layer : "beauty";
    if (!layer_read(&pictures->test, pictures->test_path, layer, &test_encoded) ||
        !layer_read(&pictures->reference, pictures->reference_path,
                    values->reference_layer ? values->reference_layer : layer, &reference_encoded))
        return false;
    pictures->any_encoded = test_encoded || reference_encoded;
    return check_sizes(pictures);
}

static void print_table(FILE *out, const struct report *report) {
    for (int i = 0; i < METRIC_COUNT; i++) {
        const struct measurement *m = &report->measurements[i];
        if (!m->asked)
            continue;
        fprintf(out, "%-14s %12.6g", metrics[i].name, m->value);
        if (isfinite(m->bound))
            fprintf(out, "  (at most %g)", m->bound);
        fprintf(out, "\n");
    }
}

static void print_json(FILE *out, const struct report *report, const struct values *values,
                       const struct pictures *pictures) {
    struct json json = {.out = out};
    json_open(&json, NULL, "{");
    json_text(&json, "test", pictures->test_path);
    json_text(&json, "reference", pictures->reference_path);
    json_text(&json, "layer", values->layer ? values->layer : "beauty");
    if (values->reference_layer)
        json_text(&json, "reference-layer", values->reference_layer);
    json_number(&json, "width", pictures->test.width);
    json_number(&json, "height", pictures->test.height);
    json_number(&json, "ppd", (double)values->pixels_per_degree);
    if (asks_hdr_flip(report)) {
        json_open(&json, "exposures", "[");
        json_number(&json, NULL, (double)report->exposures.first);
        json_number(&json, NULL, (double)report->exposures.last);
        json_number(&json, NULL, report->exposures.count);
        json_close(&json, "]");
    }
    json_open(&json, "metrics", "{");
    for (int i = 0; i < METRIC_COUNT; i++)
        if (report->measurements[i].asked)
            json_number(&json, metrics[i].name, report->measurements[i].value);
    json_close(&json, "}");
    json_close(&json, "}");
}

static bool write_map(const struct values *values, const struct metric *metric, double value,
                      const struct image *size, const float *map) {
    size_t pixel_count = (size_t)size->width * (size_t)size->height;
    float top = metric->range == RANGE_UNIT ? 1 : heat_map_fit_top(map, pixel_count);
    char title[64];
    snprintf(title, sizeof title, "%s %.4g", metric->name, value);
    return heat_map_write(&(struct heat_map){.title = title,
                                             .width = size->width,
                                             .height = size->height,
                                             .values = map,
                                             .top = values->top > 0 ? values->top : top,
                                             .is_signed = metric->range == RANGE_SIGNED},
                          values->output);
}

static bool measure(struct report *report, const struct values *values,
                    const struct pictures *pictures) {
    struct comparison comparison = {.test = &pictures->test,
                                    .reference = &pictures->reference,
                                    .pixels_per_degree = values->pixels_per_degree,
                                    .exposures = report->exposures};
    size_t pixel_count = (size_t)pictures->test.width * (size_t)pictures->test.height;
    float *map = mem_alloc(pixel_count, sizeof *map);
    bool ok = true;
    for (int i = 0; ok && i < METRIC_COUNT; i++) {
        struct measurement *m = &report->measurements[i];
        if (!m->asked)
            continue;
        m->value = metric_measure(&metrics[i], &comparison, map);
        if (values->output && report->pictured == &metrics[i])
            ok = write_map(values, &metrics[i], m->value, &pictures->test, map);
    }
    free(map);
    return ok;
}

/* Says on stderr which metric is over its bound. NaN is. */
static int check_bounds(const struct report *report, const char *name) {
    int status = STATUS_OK;
    for (int i = 0; i < METRIC_COUNT; i++) {
        const struct measurement *m = &report->measurements[i];
        if (!m->asked || fabs(m->value) <= m->bound)
            continue;
        error_set("%s is %.6g, above %g", metrics[i].name, m->value, m->bound);
        status = arguments_fail(name);
    }
    return status;
}

static int compare(const struct values *values, struct report *report, struct pictures *pictures,
                   const char *name) {
    const char *const inputs[] = {pictures->test_path, pictures->reference_path};
    if ((values->output && !output_file_check(values->output, inputs, 2)) ||
        !pictures_read(pictures, values))
        return arguments_fail(name);
    int kind = pictures->any_encoded ? METRIC_LDR : METRIC_HDR;
    /* Without --metric: those usual for this kind of picture. */
    for (int i = 0; values->metrics.count == 0 && i < METRIC_COUNT; i++)
        if (metrics[i].usual_for & kind)
            report->measurements[i].asked = true;
    if (!asks_hdr_flip(report) && values->exposures) {
        error_set("--exposures needs hdr-flip, and integers are compared by ldr-flip: add "
                  "--metric hdr-flip");
        return arguments_fail(name);
    }
    if (asks_hdr_flip(report) && report->exposures.count == 0)
        report->exposures = hdr_flip_exposures(&pictures->reference);
    if (!report->pictured)
        report->pictured = metric_find(kind == METRIC_LDR ? "ldr-flip" : "hdr-flip");
    if (!measure(report, values, pictures))
        return arguments_fail(name);
    FILE *out = outputs_table_stream(&values->output, 1);
    if (values->json)
        print_json(out, report, values, pictures);
    else
        print_table(out, report);
    return check_bounds(report, name);
}

int app_compare(int argc, char **argv) {
    struct values values = {0};
    const char *paths[2];
    int path_count, status;
    if (!arguments_parse(&arguments, &values, argc, argv, paths, &path_count, &status))
        return status;
    struct report report;
    if (!inputs_check(paths, path_count) || !report_init(&report, &values))
        return arguments_misuse(argv[0]);
    struct pictures pictures = {.test_path = paths[0], .reference_path = paths[1]};
    status = compare(&values, &report, &pictures, argv[0]);
    images_free(&pictures.test, &pictures.reference);
    return status;
}
