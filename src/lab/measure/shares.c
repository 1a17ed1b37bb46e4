#include "lab/measure/shares.h"

#include "base/error.h"
#include "lab/measure/reference.h"

#include <math.h>

/* The layers' first channels; noise: of what holds the share, the standard error. */
struct layers {
    int test, direct, unshadowed, visibility, noise;
};

static bool find_layer(const struct image *image, const char *name, int *first) {
    int channels[3];
    *first = 0;
    if (!image_find_layer(image, name, channels))
        return false;
    *first = channels[0];
    return true;
}

static bool find_noise(const struct image *reference, bool of_sky, int *channel) {
    const char *name = of_sky ? "standard_error.direct.Y" : "standard_error.visibility.Y";
    *channel = image_find_channel(reference, name);
    return *channel >= 0 || error_set("no channel %s", name);
}

/* The mean of three channels; those of a layer lie side by side. */
static double grey(const struct image *image, int x, int y, int first) {
    const float *pixel = image_at(image, x, y) + first;
    return (double)(pixel[0] + pixel[1] + pixel[2]) / 3;
}

static double share_of(double light, double unshadowed) {
    return fmin(fmax(light / unshadowed, 0), 1);
}

static double brightest(const struct image *reference, int first) {
    double most = 0;
    for (int y = 0; y < reference->height; y++)
        for (int x = 0; x < reference->width; x++)
            most = fmax(most, grey(reference, x, y, first));
    return most;
}

struct sums {
    double squares, sum, noise_squares, count;
};

static void add(struct sums *sums, double off, double noise) {
    sums->squares += off * off;
    sums->noise_squares += noise * noise;
    sums->sum += off;
    sums->count++;
}

static double percent(double squares, double count) {
    return 100 * sqrt(fmax(squares, 0) / fmax(count, 1));
}

static double rms(const struct sums *sums) {
    return percent(sums->squares - sums->noise_squares, sums->count);
}

static void add_all(struct results *results, const struct sums *all, const struct sums *bright) {
    const char *against = reference_names[REFERENCE_SEEN];
    results_add(results, "visible-share", against, "%", rms(bright));
    results_add(results, "visible-bias", against, "%", 100 * bright->sum / fmax(bright->count, 1));
    results_add(results, "visible-share-all", against, "%", rms(all));
    results_add(results, "visible-noise", against, "%",
                percent(bright->noise_squares, bright->count));
}

bool shares_add(struct results *results, const struct image *test, const struct image *reference,
                bool of_sky) {
    struct layers at;
    struct sums all = {0}, bright = {0};
    if (!find_layer(test, "direct", &at.test) || !find_layer(reference, "direct", &at.direct) ||
        !find_layer(reference, "unshadowed", &at.unshadowed) ||
        !find_layer(reference, "visibility", &at.visibility) ||
        !find_noise(reference, of_sky, &at.noise))
        return error_prefix("visible share");
    double least = .01 * brightest(reference, at.unshadowed);
    for (int y = 0; y < reference->height; y++)
        for (int x = 0; x < reference->width; x++) {
            double unshadowed = grey(reference, x, y, at.unshadowed);
            if (!(unshadowed > 0))
                continue;
            double seen = of_sky ? share_of(grey(reference, x, y, at.direct), unshadowed)
                                 : grey(reference, x, y, at.visibility);
            double off = share_of(grey(test, x, y, at.test), unshadowed) - seen;
            double noise = (double)image_at(reference, x, y)[at.noise] / (of_sky ? unshadowed : 1);
            add(&all, off, noise);
            if (unshadowed >= least)
                add(&bright, off, noise);
        }
    add_all(results, &all, &bright);
    return true;
}
