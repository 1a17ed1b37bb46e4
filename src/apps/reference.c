/* manylight reference: path-traced ground truth. */
#include "apps/apps.h"
#include "apps/arguments.h"
#include "apps/progress.h"

#include "base/error.h"
#include "base/image_file.h"
#include "base/log.h"
#include "reference/path_tracer.h"

#include <stdlib.h>
#include <string.h>

struct values {
    struct common_values common;
    const char *output, *noise, *camera, *light;
    int size[2], bounces, samples, seed;
    float time;
};

static const struct option options[] = {
    {"output", 'o', OPTION_TEXT, offsetof(struct values, output), .value_name = "FILE.exr",
     .help = "the picture to write"},
    {"size", 0, OPTION_SIZE, offsetof(struct values, size), 800, 1, 16384,
     .help = "of the picture, pixels"},
    {"bounces", 0, OPTION_INT, offsetof(struct values, bounces), 1, 0, 1000,
     .help = "of indirect light; 0 = direct light only"},
    {"spp", 0, OPTION_INT, offsetof(struct values, samples), 0, 0, 1e6,
     .help = "samples per pixel, in steps of 4; 0 = by --noise"},
    {"noise", 0, OPTION_TEXT, offsetof(struct values, noise), .value_name = "X%",
     .help = "samples until the indirect light's standard error (RMS over mean) is below [1%]"},
    {"seed", 0, OPTION_INT, offsetof(struct values, seed), 0, 0, 2147483647,
     .help = "another seed, another noise"},
    {"camera", 0, OPTION_TEXT, offsetof(struct values, camera), .value_name = "NAME|N",
     .help = "camera of the scene [the first]"},
    {"light", 0, OPTION_TEXT, offsetof(struct values, light), .value_name = "NAME|N",
     .help = "light of the scene [the first]"},
    {"time", 0, OPTION_FLOAT, offsetof(struct values, time), 0, 0, 1e6, .value_name = "SECONDS",
     .help = "of the animation"},
    {NULL},
};

static const struct arguments arguments = {
    .synopsis = "SCENE -o FILE.exr [OPTION ...]",
    .summary = "Path traces the scene on all cores. The layers are those of render: beauty, Z,\n"
               "direct, indirect (irradiance / pi, without albedo), albedo, normal; and\n"
               "standard_error, that of the indirect layer.",
    .options = options,
    .min_positional = 1,
    .max_positional = 1,
};

/* "1%" or "0.01". */
static bool parse_noise(const char *text, double *noise) {
    char *end;
    *noise = strtod(text, &end);
    if (strcmp(end, "%") == 0)
        *noise /= 100;
    else if (*end)
        *noise = 0;
    return (*noise >= 1e-6 && *noise <= 1) ||
           error_set("noise: '%s' is not a share from 0.0001%% to 100%%", text);
}

static bool check_values(const struct values *values, double *noise) {
    *noise = 0;
    if (!values->output)
        return error_set("-o FILE.exr is missing");
    const char *extension = strrchr(values->output, '.');
    if (!extension || strcmp(extension, ".exr") != 0)
        return error_set("%s: only EXR files (.exr) hold all layers", values->output);
    if (values->noise && values->samples > 0)
        return error_set("--spp and --noise exclude each other");
    return !values->noise || parse_noise(values->noise, noise);
}

static bool find_nodes(const struct scene *scene, const struct values *values, int *camera,
                       int *light) {
    *camera = values->camera ? camera_find(scene, values->camera) : 0;
    *light = values->light ? light_find(scene, values->light) : 0;
    return *camera >= 0 && *light >= 0;
}

static bool show(void *user, const struct path_tracer_progress *progress) {
    char note[64] = "";
    if (progress->samples > 0)
        snprintf(note, sizeof note, "%d samples, noise %.2f %%", progress->samples,
                 100 * progress->noise);
    progress_show(user, progress->done, note);
    return true;
}

static bool trace(const struct values *values, double noise, const struct scene *scene,
                  const struct geometry *geometry, struct image *image) {
    int camera_number, light_number;
    struct camera camera;
    struct light light;
    struct progress progress;
    struct path_tracer_progress reached;
    if (!find_nodes(scene, values, &camera_number, &light_number))
        return false;
    camera_place(&camera, scene, camera_number, values->time);
    light_place(&light, scene, light_number, values->time);
    progress_start(&progress);
    bool ok = path_tracer_render(&(struct path_tracer_desc){.scene = scene,
                                                            .geometry = geometry,
                                                            .camera = &camera,
                                                            .light = &light,
                                                            .width = values->size[0],
                                                            .height = values->size[1],
                                                            .bounces = values->bounces,
                                                            .samples = values->samples,
                                                            .noise = noise,
                                                            .seed = (uint32_t)values->seed,
                                                            .progress = show,
                                                            .user = &progress},
                                 image, &reached);
    double seconds = progress_end(&progress);
    if (ok)
        log_note("%d samples per pixel in %.1f s, noise of the indirect light %.2f %%",
                 reached.samples, seconds, 100 * reached.noise);
    return ok;
}

int app_reference(int argc, char **argv) {
    struct values values;
    const char *path;
    int status, count;
    double noise;
    struct scene scene = {0};
    struct geometry geometry = {0};
    struct image image = {0};
    if (!arguments_parse(&arguments, &values, argc, argv, &path, &count, &status))
        return status;
    if (!check_values(&values, &noise))
        return arguments_misuse(argv[0]);
    bool ok = scene_load(&scene, path) && geometry_init(&geometry, &scene, values.time) &&
              trace(&values, noise, &scene, &geometry, &image) &&
              image_write(&image, values.output);
    image_free(&image);
    geometry_free(&geometry);
    scene_free(&scene);
    return ok ? STATUS_OK : arguments_fail(argv[0]);
}
