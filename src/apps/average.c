/* manylight average: one picture of several that are means of other passes of it. */
#include "apps/arguments.h"
#include "apps/frames.h"
#include "apps/outputs.h"
#include "apps/subcommands.h"

#include "base/error.h"
#include "base/file/image_file.h"
#include "base/file/output_file.h"
#include "base/file/piped_file.h"
#include "base/memory.h"
#include "base/primaries.h"

#include <string.h>

struct values {
    struct common_values common;
    const char *output, *format;
};

enum { PICTURES_MAX = 4096 };

static const struct option options[] = {
    {"output", 'o', OPTION_TEXT, offsetof(struct values, output), .value_name = "FILE.exr",
     .help = "picture to write"},
    EXR_FORMAT_OPTION(struct values, format),
    {NULL},
};

static const struct arguments arguments = {
    .synopsis = "A.exr B.exr ... -o FILE.exr",
    .summary =
        "Averages pictures of manylight render --passes K --first-pass N, weighted by their "
        "passes.\n"
        "The result is the picture of all passes at once, but for Z and normals where a pass\n"
        "has a surface's edge and a pane before nothing in one pixel. A pass in two of the\n"
        "pictures is an error.\n"
        "Irradiance is weighted by albedo, depth and normal by coverage.\n"
        "A picture - is standard input; -o - is standard output, with --format exr.",
    .options = options,
    .min_positional = 1,
    .max_positional = PICTURES_MAX,
};

static const char *const of_surface[] = {"Z", "albedo.R", "albedo.G", "albedo.B"};
enum { OF_SURFACE = sizeof of_surface / sizeof *of_surface };

/* Channels of its pixel that weight a channel's mean; -1: none. Coverage counts panes, too: it is
 * of surfaces only where one of their channels is not 0. */
struct weighting {
    int albedo, coverage, surface[OF_SURFACE];
};

static bool has_surface(const struct weighting *by, const float *pixel) {
    bool has = false;
    for (int i = 0; i < OF_SURFACE; i++)
        has |= by->surface[i] >= 0 && pixel[by->surface[i]] > 0;
    return has;
}

/* As src/passes/picture/layer_shown.glsl. */
static double weight_of(const struct weighting *by, const float *pixel) {
    const double least = 1e-6;
    double coverage = by->coverage < 0         ? 1
                      : has_surface(by, pixel) ? (double)pixel[by->coverage]
                                               : 0;
    return by->albedo < 0 ? coverage : (double)pixel[by->albedo] + least * coverage;
}

static bool starts_with(const char *text, const char *start) {
    return strncmp(text, start, strlen(start)) == 0;
}

static bool find_weighting(const struct image *image, int channel, struct weighting *by) {
    const char *name = image->names[channel], *colour = strrchr(name, '.');
    bool received = (starts_with(name, "direct.") || starts_with(name, "indirect.") ||
                     starts_with(name, "caustic.")) &&
                    !strstr(name, ".specular.");
    *by = (struct weighting){.albedo = -1, .coverage = -1};
    for (int i = 0; i < OF_SURFACE; i++)
        by->surface[i] = image_find_channel(image, of_surface[i]);
    if (received || starts_with(name, "normal.") || strcmp(name, "Z") == 0)
        by->coverage = image_find_channel(image, "A");
    if (received) {
        char *albedo = mem_printf("albedo%s", colour);
        by->albedo = image_find_channel(image, albedo);
        free(albedo);
        return by->albedo >= 0 || error_set("there is %s, but no albedo to weight it by", name);
    }
    return true;
}

/* Sums, and of what they are sums. */
struct mean {
    struct image first; /* tells names and size; without pixels' meaning */
    struct weighting *by;
    double *sums, *weights; /* of each channel of each pixel */
    struct frames passes;
    double weight;
};

static void mean_free(struct mean *mean) {
    image_free(&mean->first);
    frames_free(&mean->passes);
    mem_free(mean->by, mean->sums, mean->weights);
}

static bool begin(struct mean *mean, struct image *image) {
    size_t channels = (size_t)image->channel_count;
    size_t count = (size_t)image->width * (size_t)image->height * channels;
    if (!mem_check(2 * count * sizeof *mean->sums))
        return false;
    mean->first = *image;
    mean->by = mem_alloc(channels, sizeof *mean->by);
    mean->sums = mem_alloc(count, sizeof *mean->sums);
    mean->weights = mem_alloc(count, sizeof *mean->weights);
    for (int c = 0; c < image->channel_count; c++)
        if (!find_weighting(image, c, &mean->by[c]))
            return false;
    return true;
}

static bool is_alike(const struct image *a, const struct image *b) {
    if (a->width != b->width || a->height != b->height)
        return error_set("%dx%d pixels, where the first has %dx%d", b->width, b->height, a->width,
                         a->height);
    bool same = a->channel_count == b->channel_count;
    for (int c = 0; same && c < a->channel_count; c++)
        same = strcmp(a->names[c], b->names[c]) == 0;
    return same || error_set("other layers than the first has");
}

static bool add_passes(struct mean *mean, const struct image *image) {
    struct frames more;
    int twice;
    if (!image->passes || !(image->weight > 0))
        return error_set("does not tell its passes: manylight render --passes writes such files");
    if (!frames_parse(&more, image->passes))
        return false;
    int count = mean->passes.count + more.count;
    mean->passes.numbers =
        mem_resize(mean->passes.numbers, (size_t)count, sizeof *mean->passes.numbers);
    memcpy(mean->passes.numbers + mean->passes.count, more.numbers,
           (size_t)more.count * sizeof *more.numbers);
    mean->passes.count = count;
    frames_free(&more);
    return frames_sort(&mean->passes, &twice) ||
           error_set("pass %d is in it and in one before", twice);
}

static void add_pixels(struct mean *mean, const struct image *image) {
    int channels = image->channel_count;
    for (size_t i = 0; i < (size_t)image->width * (size_t)image->height; i++) {
        const float *pixel = image->pixels + i * (size_t)channels;
        for (int c = 0; c < channels; c++) {
            double weight = image->weight * weight_of(&mean->by[c], pixel);
            mean->sums[i * (size_t)channels + (size_t)c] += weight * (double)pixel[c];
            mean->weights[i * (size_t)channels + (size_t)c] += weight;
        }
    }
    mean->weight += image->weight;
}

/* The first picture stays as the mean's. */
static bool add_file(struct mean *mean, const char *path) {
    struct image image;
    if (!piped_image_read(&image, path))
        return false;
    bool first = !mean->first.pixels;
    bool ok =
        (first ? begin(mean, &image) : is_alike(&mean->first, &image)) && add_passes(mean, &image);
    if (ok)
        add_pixels(mean, &image);
    if (mean->first.pixels != image.pixels)
        image_free(&image);
    return ok || error_prefix("%s", path);
}

static bool write_mean(struct mean *mean, const char *path) {
    struct image *image = &mean->first;
    size_t count = (size_t)image->width * (size_t)image->height * (size_t)image->channel_count;
    for (size_t i = 0; i < count; i++)
        image->pixels[i] = mean->weights[i] > 0 ? (float)(mean->sums[i] / mean->weights[i]) : 0;
    free(image->passes);
    image->passes = frames_text(&mean->passes);
    image->weight = mean->weight;
    image_add_numbers(image, "chromaticities", IMAGE_CHROMATICITIES, primaries_bt709);
    return image_write(image, path);
}

int app_average(int argc, char **argv) {
    struct values values = {0};
    const char *paths[PICTURES_MAX];
    int count, status;
    if (!arguments_parse(&arguments, &values, argc, argv, paths, &count, &status))
        return status;
    if (!values.output)
        error_set("no output: -o FILE.exr");
    if (!values.output || !outputs_use_format(&values.output, 1, values.format) ||
        !image_name_holds_layers(values.output) || !inputs_check(paths, count))
        return arguments_misuse(argv[0]);
    struct mean mean = {0};
    bool ok = output_file_check(values.output, paths, count);
    for (int i = 0; ok && i < count; i++)
        ok = add_file(&mean, paths[i]);
    ok = ok && write_mean(&mean, values.output);
    mean_free(&mean);
    return ok ? STATUS_OK : arguments_fail(argv[0]);
}
