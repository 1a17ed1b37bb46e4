/* manylight probe: irradiance or illuminance at points of a scene, as a table. */
#include "apps/arguments.h"
#include "apps/options.h"
#include "apps/points.h"
#include "apps/subcommands.h"

#include "base/error.h"
#include "base/file/image_file.h"
#include "base/file/output_file.h"
#include "base/log.h"
#include "base/memory.h"
#include "metrics/heat_map.h"
#include "quality/meter.h"
#include "quality/picture.h"
#include "scene/material.h"
#include "scene/medium.h"
#include "techniques/many_lights.h"

#include <math.h>

enum unit { UNIT_WATTS, UNIT_LUX };
enum way { BY_REFERENCE, BY_FRAME };

static const char *const unit_names[] = {"W/m2", "lux", NULL};
static const char *const way_names[] = {"reference", "frame", NULL};

struct values {
    struct common_values common;
    struct context_desc context;
    struct technique_values technique;
    struct stage_desc stage;
    struct path_tracer_desc tracer;
    const char *points, *grid, *output, *map;
    float noise, efficacy;
    int unit, by;
};

static const struct option options[] = {
    {"grid", 0, OPTION_TEXT, offsetof(struct values, grid),
     .value_name = "x,y,z,ux,uy,uz,vx,vy,vz,NUxNV",
     .help = "in place of POINTS the middles of NU x NV cells of a parallelogram: corner and two\n"
             "sides u and v, metres; the points face u x v"},
    {"output", 'o', OPTION_TEXT, offsetof(struct values, output), .value_name = "FILE",
     .help = "table to write [standard output]"},
    {"map", 0, OPTION_TEXT, offsetof(struct values, map), .value_name = "FILE",
     .help = "also total light of the grid in false colours with a scale, v up; EXR: its values"},
    {"by", 0, OPTION_CHOICE, offsetof(struct values, by), .choices = way_names,
     .help = "path tracing, with its standard error; or frames, as render draws them"},
    {"unit", 0, OPTION_CHOICE, offsetof(struct values, unit), UNIT_LUX, .choices = unit_names,
     .help = "unit of the table"},
    {"efficacy", 0, OPTION_FLOAT, offsetof(struct values, efficacy), 1, 1e-3, 1e6,
     .value_name = "LM/W",
     .help = "lumens for each watt of the scene; 1: its lights are in candela, lumens or nits, as\n"
             "in glTF and IES files; 683: in watts of light, by the lumen's definition at 555 nm;\n"
             "179: in watts of Radiance, whose white light has so many lumens"},
    {"bounces", 0, OPTION_INT, offsetof(struct values, tracer.bounces), 8, 0, 1000,
     .help = "number of indirect bounces; 0: direct light only (with --by reference);\n"
             "--set lights.bounces overrides it"},
    {"spp", 0, OPTION_INT, offsetof(struct values, tracer.samples), 0, 0, 1e6,
     .help = "samples per point; 0: by --noise"},
    {"noise", 0, OPTION_FLOAT, offsetof(struct values, noise), 0, 0, 1, .value_name = "X%",
     .help = "limit of the standard error over the mean of all points; 0: 1%"},
    {"seed", 0, OPTION_INT, offsetof(struct values, tracer.seed), 0, 0, 2147483647,
     .help = "seed of the random numbers; another seed has other noise"},
    TECHNIQUE_OPTIONS(struct values, technique),
    LIGHTING_OPTIONS(struct values, stage),
    SCENE_OPTION(struct values, stage.choice),
    VARIANT_OPTION(struct values, stage.choice),
    CONTEXT_OPTIONS(struct values, context),
    {NULL},
};

static void print_more(FILE *out, const void *values) {
    const struct values *own = values;
    technique_values_print_help(out, &own->technique, own->common.help_all);
}

static const struct arguments arguments = {
    .synopsis = "SCENE POINTS.csv [OPTION ...]",
    .summary =
        "Measures the light that arrives at points, from all directions around a normal. POINTS\n"
        "has lines of x,y,z,nx,ny,nz, metres of the scene's file; a line of names may come first.\n"
        "The table has these columns, then direct, indirect and total light, and with --by\n"
        "reference the standard error of the total. Its last line, after #, has mean, least,\n"
        "greatest and uniformity, which is least over mean. Colours count by their luminance\n"
        "(ITU-R BT.709). Caustics are left out. SCENE - is standard input.",
    .options = options,
    .opens_scenes = true,
    .shows_progress = true,
    .min_positional = 1,
    .max_positional = 2,
    .print_more = print_more,
};

static bool check_values(struct values *values) {
    bool by_frame = values->by == BY_FRAME;
    if (!values->points == !values->grid)
        return error_set("it wants POINTS.csv or --grid: one of both");
    if (values->tracer.samples > 0 && values->noise > 0)
        return error_set("--spp and --noise exclude each other");
    if (by_frame && values->tracer.bounces == 0)
        return error_set("--bounces 0 is for --by reference: a frame has one bounce or more");
    values->tracer.noise = (double)values->noise;
    return arguments_check_use(
        &values->common,
        (struct option_use[]){
            {"spp noise seed", !by_frame, "--by reference"},
            {"technique direct set context device screen-passes gl-debug", by_frame, "--by frame"},
            {"map", values->grid != NULL, "--grid"},
            {"efficacy", values->unit == UNIT_LUX, "--unit lux"},
            {NULL}});
}

static bool resolve(const struct values *values, struct measure_desc *desc) {
    const struct technique_values *technique = &values->technique;
    char *bounces = mem_printf("lights.bounces=%d", values->tracer.bounces);
    *desc = measure_default(NULL, 0, 0);
    bool ok =
        technique_values_resolve(technique, &desc->technique, &desc->direct, &desc->settings) &&
        (values->by == BY_REFERENCE || technique_values_name(technique, &lights_part, "bounces") ||
         settings_assign(&desc->settings, bounces));
    free(bounces);
    return ok;
}

static bool measure_paths(const struct values *values, const struct stage *stage,
                          const struct points *points, const struct settings *settings,
                          struct reading *readings) {
    struct progress progress;
    struct path_tracer_progress reached;
    struct path_tracer_desc desc = values->tracer;
    desc.materials = MATERIALS_FULL;
    desc.medium = medium_of(&stage->scene, settings, stage->geometry.radius);
    desc.progress = path_progress_show;
    desc.user = &progress;
    progress_start(&progress, "paths");
    bool ok = meter_paths(stage, &desc, points->sensors, points->count, readings, &reached);
    double seconds = progress_end(&progress);
    if (ok)
        log_note("%d points, %d samples each, in %.1f s, noise %.2f %%%s", points->count,
                 reached.samples, seconds, 100 * reached.noise,
                 desc.samples == 0 && reached.noise > (desc.noise > 0 ? desc.noise : .01)
                     ? ": above --noise after the most samples"
                     : "");
    return ok;
}

static bool measure_frames(const struct values *values, const struct points *points,
                           const struct measure_desc *desc, struct reading *readings) {
    struct context *context = context_create(&values->context);
    struct progress progress;
    if (!context)
        return false;
    progress_start(&progress, "points");
    bool ok = meter_frames(desc, points->sensors, points->count, &progress, readings);
    double seconds = progress_end(&progress);
    if (ok)
        log_note("%d points in %.1f s", points->count, seconds);
    context_free(context);
    return ok;
}

/* Of all points, in the table's unit. */
struct summary {
    double unit, mean, least, greatest;
};

static double total_of(const struct reading *reading) {
    return reading->direct + reading->indirect;
}

static struct summary summarize(const struct values *values, const struct points *points,
                                const struct reading *readings) {
    double unit = values->unit == UNIT_LUX ? (double)values->efficacy : 1;
    struct summary summary = {.unit = unit, .least = INFINITY};
    for (int i = 0; i < points->count; i++) {
        double total = unit * total_of(&readings[i]);
        summary.mean += total / points->count;
        summary.least = fmin(summary.least, total);
        summary.greatest = fmax(summary.greatest, total);
    }
    return summary;
}

static void print_table(FILE *out, const struct values *values, const struct points *points,
                        const struct reading *readings) {
    bool has_error = values->by == BY_REFERENCE, in_lux = values->unit == UNIT_LUX;
    struct summary all = summarize(values, points, readings);
    double unit = all.unit;
    fprintf(out, "x,y,z,nx,ny,nz,direct,indirect,total%s\n", has_error ? ",standard_error" : "");
    for (int i = 0; i < points->count; i++) {
        const struct reading *reading = &readings[i];
        for (int c = 0; c < 6; c++)
            fprintf(out, "%.9g,", points->rows[i][c]);
        fprintf(out, "%.6g,%.6g,%.6g", unit * reading->direct, unit * reading->indirect,
                unit * total_of(reading));
        if (has_error)
            fprintf(out, ",%.3g", unit * reading->error);
        fprintf(out, "\n");
    }
    fprintf(out, "# %s", unit_names[values->unit]);
    if (in_lux)
        fprintf(out, ", %g lm for each watt of the scene", unit);
    fprintf(out, ", by %s: mean %.6g, least %.6g, greatest %.6g, uniformity %.4g\n",
            way_names[values->by], all.mean, all.least, all.greatest,
            all.mean > 0 ? all.least / all.mean : 0);
}

static bool write_table(const struct values *values, const struct points *points,
                        const struct reading *readings) {
    struct output_text text;
    output_text_init(&text);
    print_table(text.stream, values, points, readings);
    return output_text_end(&text, values->output ? values->output : "-");
}

/* A number above, whose quarters have few digits: they label the scale. */
static double scale_end(double greatest) {
    double step = greatest > 0 ? 4 * pow(10, floor(log10(greatest)) - 1) : 1;
    return fmax(ceil(greatest / step), 1) * step;
}

/* Draws the grid as a plan: u to the right, v up. */
static bool write_map(const struct values *values, const struct points *points,
                      const struct reading *readings) {
    struct summary all = summarize(values, points, readings);
    float *cells = mem_alloc((size_t)points->count, sizeof *cells);
    char title[64];
    for (int i = 0; i < points->count; i++) {
        int up = points->count / points->columns - 1 - i / points->columns;
        cells[up * points->columns + i % points->columns] =
            (float)(all.unit * total_of(&readings[i]));
    }
    snprintf(title, sizeof title, "%s. mean %.4g least %.4g most %.4g", unit_names[values->unit],
             all.mean, all.least, all.greatest);
    struct heat_map map = {.title = title,
                           .width = points->columns,
                           .height = points->count / points->columns,
                           .values = cells,
                           .top = (float)scale_end(all.greatest)};
    bool ok = heat_map_write(&map, values->map);
    free(cells);
    return ok;
}

static bool check_outputs(const struct values *values) {
    const char *const inputs[] = {values->points, values->output};
    bool is_float;
    return (!values->output || output_file_check(values->output, inputs, 1)) &&
           (!values->map || (image_format_is_float(values->map, &is_float) &&
                             output_file_check(values->map, inputs, 2)));
}

static bool probe(const struct values *values, struct points *points, struct measure_desc *desc) {
    struct stage stage;
    if (!check_outputs(values) || !stage_init(&stage, &values->stage))
        return false;
    struct reading *readings = mem_alloc((size_t)points->count, sizeof *readings);
    desc->stage = &stage;
    points_place(points, stage.scene.origin);
    bool ok = (!values->output || scene_check_output(&stage.scene, values->output)) &&
              (!values->map || scene_check_output(&stage.scene, values->map)) &&
              (values->by == BY_REFERENCE
                   ? measure_paths(values, &stage, points, &desc->settings, readings)
                   : measure_frames(values, points, desc, readings)) &&
              write_table(values, points, readings) &&
              (!values->map || write_map(values, points, readings));
    free(readings);
    stage_free(&stage);
    return ok;
}

int app_probe(int argc, char **argv) {
    struct values values = {0};
    struct points points;
    struct measure_desc desc;
    const char *named[2];
    int count, status;
    if (!arguments_parse(&arguments, &values, argc, argv, named, &count, &status))
        return status;
    values.stage.path = named[0];
    values.points = named[1];
    if (!check_values(&values) || !resolve(&values, &desc) ||
        (values.grid && !points_parse_grid(&points, values.grid)))
        return arguments_misuse(argv[0]);
    bool ok =
        (values.grid || points_read(&points, values.points)) && probe(&values, &points, &desc);
    points_free(&points);
    return ok ? STATUS_OK : arguments_fail(argv[0]);
}
