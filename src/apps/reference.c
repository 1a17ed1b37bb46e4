/* manylight reference: the path-traced reference; or what the GPU's VPLs would make of it if their
 * visibility were exact. */
#include "apps/arguments.h"
#include "apps/background.h"
#include "apps/options.h"
#include "apps/outputs.h"
#include "apps/subcommands.h"

#include "base/error.h"
#include "base/file/image_file.h"
#include "base/file/output_file.h"
#include "base/log.h"
#include "base/memory.h"
#include "base/parallel.h"
#include "base/progress.h"
#include "inspect/aov.h"
#include "quality/picture.h"
#include "renderer/about.h"
#include "renderer/stage.h"
#include "scene/caustics.h"
#include "scene/lens.h"
#include "scene/material.h"
#include "scene/medium.h"
#include "shared/composite.h"

#include <string.h>

enum reference_technique { TECHNIQUE_PATH, TECHNIQUE_VPL_RAYTRACED };

static const char *const reference_techniques[] = {"path", "vpl-raytraced", NULL};

struct values {
    struct common_values common;
    struct context_desc context;
    struct stage_desc stage;
    struct path_tracer_desc tracer;
    struct text_list settings;
    const char *output, *format, *background, *ao;
    float noise;
    int technique, light_paths, threads;
};

OPTION_ASSERT_SIZE(struct path_tracer_desc, width, height);

static const struct option options[] = {
    {"output", 'o', OPTION_TEXT, offsetof(struct values, output), .value_name = "FILE.exr",
     .help = "picture to write"},
    EXR_FORMAT_OPTION(struct values, format),
    {"size", 0, OPTION_SIZE, offsetof(struct values, tracer.width), 0, 1, 16384, .help = SIZE_HELP},
    {"technique", 0, OPTION_CHOICE, offsetof(struct values, technique),
     .choices = reference_techniques,
     .help = "path tracing, or the one-bounce sum over the VPLs of\n"
             "render with ray-traced visibility"},
    {"set", 0, OPTION_LIST, offsetof(struct values, settings), .value_name = "KEY=VALUE",
     .help = "with --technique path a setting of the medium, for example medium.scatter;\n"
             "else of the VPLs, for example vpls, seed or clamp (render --help-all); repeatable"},
    {"bounces", 0, OPTION_INT, offsetof(struct values, tracer.bounces), 1, 0, 1000,
     .help = "number of indirect bounces; 0: direct light only"},
    {"spp", 0, OPTION_INT, offsetof(struct values, tracer.samples), 0, 0, 1e6,
     .help = "samples per pixel; 0: by --noise"},
    {"paths", 0, OPTION_INT, offsetof(struct values, tracer.paths), 0, 0, 1024,
     .help = "paths of indirect light per sample; 0: 1\n"
             "below 16 samples per pixel, else 4"},
    {"noise", 0, OPTION_FLOAT, offsetof(struct values, noise), 0, 0, 1, .value_name = "X%",
     .help =
         "limit of the standard error over the mean, for indirect light, direct light of lights\n"
         "with a size or of more than 64, specular light (over the mean of all light), and ao;\n"
         "0: 1%"},
    {"centers", 0, OPTION_FLAG, offsetof(struct values, tracer.centers),
     .help = "samples at pixel centres only, as a rasteriser has them: no antialiasing"},
    {"background", 0, OPTION_TEXT, offsetof(struct values, background), .value_name = "none",
     .help =
         "none: hides the environment behind surfaces; it still lights them, and A is coverage"},
    {"seen", 0, OPTION_FLAG, offsetof(struct values, tracer.seen),
     .help = "adds the layers unshadowed (direct light without occluders) and visibility (visible\n"
             "fraction of the lights), and their standard errors: means over the colours"},
    {"ao", 0, OPTION_TEXT, offsetof(struct values, ao), .value_name = "D",
     .help =
         "adds the layer ao, ambient occlusion (fraction of cosine-weighted rays from a surface\n"
         "that meet nothing within D metres), and its standard error;\n"
         "auto: that of render --aov ao, .27 of the scene's longest side"},
    {"aov", 0, OPTION_TEXT, offsetof(struct values, tracer.surface_layers),
     .value_name = "NAME[,NAME ...]",
     .help = "adds layers of surfaces at pixel centres: id.node, id.mesh, id.material, position,\n"
             "depth (along the ray), uv, motion.next, motion.previous (pixels to 1/25 s away),\n"
             "and Cryptomatte of the samples: crypto.node, crypto.mesh, crypto.material"},
    {"denoise", 0, OPTION_FLAG, offsetof(struct values, tracer.denoise),
     .help = "filters indirect light along surfaces by its noise, for few\n"
             "samples; standard_error is that of the unfiltered light"},
    {"smooth", 0, OPTION_FLAG, offsetof(struct values, tracer.smooth),
     .help = "shows the scene through glass and in mirrors; both block light, and the layer\n"
             "specular holds the radiance that they show"},
    {"light-paths", 0, OPTION_INT, offsetof(struct values, light_paths), 0, 1, 2147483647,
     .help = "light paths that trace caustics, with --smooth: adds the layers caustic\n"
             "(irradiance / pi, without albedo) and, in a medium, volume (radiance), and their\n"
             "standard errors [none]"},
    {"materials", 0, OPTION_CHOICE, offsetof(struct values, tracer.materials),
     .choices = materials_names,
     .help = "materials of surfaces: metals, roughness and\n"
             "normal maps, or diffuse in their base colour"},
    {"threads", 0, OPTION_INT, offsetof(struct values, threads), 0, 0, 256,
     .help = "number of threads; 0: one for each core", .rare = true},
    {"seed", 0, OPTION_INT, offsetof(struct values, tracer.seed), 0, 0, 2147483647,
     .help = "seed of the random numbers; another seed has other noise"},
    STAGE_OPTIONS(struct values, stage),
    SCENE_OPTION(struct values, stage.choice),
    VARIANT_OPTION(struct values, stage.choice),
    CONTEXT_OPTIONS(struct values, context),
    {NULL},
};

static const struct arguments arguments = {
    .synopsis = "SCENE -o FILE.exr [OPTION ...]",
    .summary =
        "Path-traces a scene on all CPU cores. Layers are those of render: beauty, Z, direct,\n"
        "indirect (irradiance / pi, without albedo), albedo, normal. Path tracing adds\n"
        "standard_error of the indirect layer (0 with one sample, which gives no estimate) and\n"
        "emitted, the radiance of environment and lamps. Specular surfaces add specular, the sum\n"
        "of direct.specular and indirect.specular, and standard_error.specular; the other layers\n"
        "are diffuse. A medium adds airlight and standard_error.airlight. Light paths add caustic\n"
        "and volume, and their standard errors.\n"
        "SCENE - is standard input; -o - is standard output, with --format exr.",
    .options = options,
    .opens_scenes = true,
    .shows_progress = true,
    .min_positional = 1,
    .max_positional = 1,
};

static const struct option ao_distance = {
    "ao", 0, OPTION_FLOAT, offsetof(struct values, tracer.ao_distance), 0, 1e-6, 1e9, .unit = "m"};

static bool ao_is_auto(const struct values *values) {
    return values->ao && strcmp(values->ao, "auto") == 0;
}

static bool parse_ao(struct values *values) {
    return !values->ao || ao_is_auto(values) || option_parse(&ao_distance, values, values->ao);
}

/* Sums of VPLs have one bounce, and settings of their own for the rest. */
static bool check_use(const struct values *values) {
    bool path = values->technique == TECHNIQUE_PATH;
    return arguments_check_use(
        &values->common,
        (struct option_use[]){
            {"bounces spp paths noise centers background seen ao aov denoise smooth "
             "light-paths materials seed",
             path, "--technique path"},
            {"paths denoise", values->tracer.bounces > 0, "--bounces of 1 or more"},
            {"context device screen-passes gl-debug", !path,
             "--technique vpl-raytraced, which uses OpenGL"},
            {NULL}});
}

/* Of the options for glass and mirrors; light paths need the picture that shows both. */
static bool check_light_paths(struct values *values) {
    values->tracer.smooth |= values->light_paths > 0;
    const char *option = values->light_paths > 0 ? "--light-paths" : "--smooth";
    return !values->tracer.smooth || values->tracer.materials == MATERIALS_FULL ||
           error_set("%s is for --materials full, which has glass and mirrors", option);
}

static bool check_values(struct values *values) {
    struct background background;
    if (!values->output)
        return error_set("-o FILE.exr is missing");
    if (!outputs_use_format(&values->output, 1, values->format) ||
        !image_name_holds_layers(values->output))
        return false;
    if (values->noise > 0 && values->tracer.samples > 0)
        return error_set("--spp and --noise exclude each other");
    if (!check_use(values) || !check_light_paths(values))
        return false;
    if (!aov_check_surfaces(values->tracer.surface_layers, values->tracer.centers) ||
        !parse_ao(values) || !background_parse(&background, values->background) ||
        !background_check(&background, &values->output, 1))
        return false;
    if (values->threads > 0)
        parallel_set_most(values->threads);
    values->tracer.hides_sky = background.kind != BACKGROUND_SCENE;
    values->tracer.noise = (double)values->noise;
    return true;
}

static bool show_light(void *user, double done) {
    progress_show(user, done, "light paths");
    return true;
}

static bool trace_light(const struct values *values, const struct stage *stage,
                        const struct medium *medium, struct image *image) {
    struct progress progress;
    struct light_tracer_result result;
    const struct light_tracer_desc desc = {.paths = values->light_paths,
                                           .medium = *medium,
                                           .seed = values->tracer.seed,
                                           .progress = show_light,
                                           .user = &progress};
    if (values->light_paths == 0)
        return true;
    progress_start(&progress, "light paths");
    bool ok = picture_trace_light(stage, &desc, image, &result);
    double seconds = progress_end(&progress);
    if (ok && !result.has_smooth)
        log_note(
            "the scene has no glass (transmission above 0.5) and no mirror (metal of roughness "
            "below 0.1): caustic is black");
    else if (ok && result.noise == 0)
        log_note("%d light paths in %.1f s: no caustic is in view, or they are too few to tell "
                 "their noise",
                 values->light_paths, seconds);
    else if (ok)
        log_note("%d light paths in %.1f s, noise of caustics %.2f %%", values->light_paths,
                 seconds, 100 * result.noise);
    return ok;
}

static bool trace_paths(const struct values *values, struct stage *stage,
                        const struct settings *settings, struct image *image) {
    struct progress progress;
    struct path_tracer_progress reached;
    struct path_tracer_desc desc = values->tracer;
    struct surface_motion motion = {.positions = {NULL}};
    if (!desc.smooth)
        caustics_note_straight(&stage->scene);
    if (ao_is_auto(values))
        desc.ao_distance = renderer_ao_distance(settings, &stage->geometry);
    if (ao_is_auto(values) && desc.ao_distance == 0)
        return error_set("ao: 'auto' needs volumes, which this build is without");
    if (surface_layers_move(desc.surface_layers) &&
        !stage_find_motion(stage, (double)values->stage.time, 1 / 25., &motion))
        return false; /* and the program ends */
    desc.medium = medium_of(&stage->scene, settings, stage->geometry.radius);
    desc.progress = path_progress_show;
    desc.user = &progress;
    desc.motion = &motion;
    progress_start(&progress, "paths");
    bool ok = picture_trace_paths(stage, &desc, image, &reached);
    double seconds = progress_end(&progress);
    surface_motion_free(&motion);
    if (ok && reached.samples == 1)
        log_note("1 sample per pixel in %.1f s, which does not tell its noise", seconds);
    else if (ok)
        log_note("%d samples per pixel in %.1f s, noise %.2f %%%s", reached.samples, seconds,
                 100 * reached.noise, desc.denoise ? " before the filter" : "");
    return ok && trace_light(values, stage, &desc.medium, image);
}

static bool trace_vpls(const struct values *values, const struct stage *stage,
                       struct measure_desc *desc, struct image *image) {
    struct context *context = context_create(&values->context);
    struct progress progress;
    if (!context)
        return false;
    desc->stage = stage;
    progress_start(&progress, "vpls");
    bool ok = picture_trace(desc, &progress, image);
    double seconds = progress_end(&progress);
    if (ok)
        log_note("VPLs summed in %.1f s", seconds);
    context_free(context);
    return ok;
}

/* Paths know of the medium alone, and sums of VPLs know no medium. */
static bool check_given(const struct values *values, const struct settings *settings) {
    bool is_path = values->technique == TECHNIQUE_PATH;
    for (int i = 0; i < settings->part_count; i++) {
        const struct settings_part *part = settings->parts[i];
        if (!settings->given[i] || (part == &medium_part) == is_path)
            continue;
        return error_set(is_path
                             ? "--set %s...: for --technique vpl-raytraced; "
                               "paths take settings of the medium alone"
                             : "--set %s...: for --technique path; sums of VPLs ignore a medium",
                         part->owner);
    }
    return true;
}

static bool parse_settings(const struct values *values, struct measure_desc *desc) {
    *desc = measure_default(NULL, values->tracer.width, values->tracer.height);
    return measure_assign_all(desc, values->settings.items, values->settings.count) &&
           check_given(values, &desc->settings) && measure_check(desc);
}

/* Where the options tell none. */
static void choose_size(struct values *values, struct measure_desc *desc,
                        const struct stage *stage) {
    int size[2];
    stage_default_size(stage, size);
    if (values->tracer.width == 0) {
        values->tracer.width = size[0];
        values->tracer.height = size[1];
    }
    if (desc->width == 0) {
        desc->width = size[0];
        desc->height = size[1];
    }
}

/* Light paths meet a plain pinhole. */
static bool check_lens(const struct values *values, const struct camera *camera) {
    return lens_check_size(camera, values->tracer.width, values->tracer.height) &&
           (values->light_paths == 0 || !(camera_is_wide(camera) || camera_is_distorted(camera)) ||
            error_set("--light-paths: for a plain pinhole, without lens=, skew and distortion"));
}

int app_reference(int argc, char **argv) {
    struct values values = {0};
    struct measure_desc desc;
    int status, count;
    struct stage stage;
    struct image image = {0};
    if (!arguments_parse(&arguments, &values, argc, argv, &values.stage.path, &count, &status))
        return status;
    if (!check_values(&values) || !parse_settings(&values, &desc))
        return arguments_misuse(argv[0]);
    if (!output_file_check(values.output, NULL, 0) || !stage_init(&stage, &values.stage))
        return arguments_fail(argv[0]);
    choose_size(&values, &desc, &stage);
    bool ok =
        check_lens(&values, &stage.camera) &&
        (values.technique == TECHNIQUE_PATH ? trace_paths(&values, &stage, &desc.settings, &image)
                                            : trace_vpls(&values, &stage, &desc, &image));
    if (ok)
        about_add(&image, &(struct about){.scene = values.stage.path,
                                          .camera = values.stage.camera,
                                          .technique = reference_techniques[values.technique],
                                          .placed = &stage.camera,
                                          .settings = &desc.settings,
                                          .time = (double)values.stage.time});
    ok = ok && image_write(&image, values.output);
    if (ok)
        progress_tell_file(&(struct progress){.task = "picture"}, values.output);
    image_free(&image);
    stage_free(&stage);
    return ok ? STATUS_OK : arguments_fail(argv[0]);
}
