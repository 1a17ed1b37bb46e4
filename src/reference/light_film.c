#include "reference/light_film.h"

#include "reference/channels.h"

#include "base/error.h"
#include "base/memory.h"

#include <math.h>

/* Of one channel: the present batch, and sums over batches. */
struct light_sum {
    double batch, sum, square;
};

struct light_pixel {
    struct light_sum caustic[3]; /* times the albedo */
    struct light_sum volume[3];
    double plain[3];  /* the caustic without the albedo */
    double beauty[3]; /* all, as the eye sees it */
};

bool light_film_init(struct light_film *film, int width, int height) {
    size_t pixels = (size_t)width * (size_t)height;
    *film = (struct light_film){.width = width, .height = height};
    if (!mem_check(pixels * sizeof *film->pixels))
        return error_prefix("light paths of %dx%d", width, height);
    film->pixels = mem_alloc(pixels, sizeof *film->pixels);
    return true;
}

void light_film_free(struct light_film *film) {
    free(film->pixels);
    *film = (struct light_film){0};
}

void light_film_add(struct light_film *film, const struct light_deposit *deposit) {
    struct light_pixel *pixel = &film->pixels[deposit->pixel];
    for (int c = 0; c < 3; c++) {
        double light = (double)deposit->light.raw[c];
        if (deposit->is_volume) {
            pixel->volume[c].batch += light;
            pixel->beauty[c] += light;
            continue;
        }
        double reflected = light * (double)deposit->albedo.raw[c];
        pixel->caustic[c].batch += reflected;
        pixel->plain[c] += light;
        pixel->beauty[c] += reflected * (double)deposit->passes.raw[c];
    }
}

static void end(struct light_sum *sum) {
    sum->sum += sum->batch;
    sum->square += sum->batch * sum->batch;
    sum->batch = 0;
}

void light_film_end_batch(struct light_film *film) {
    size_t count = (size_t)film->width * (size_t)film->height;
    for (size_t i = 0; i < count; i++)
        for (int c = 0; c < 3; c++) {
            end(&film->pixels[i].caustic[c]);
            end(&film->pixels[i].volume[c]);
        }
    film->batches++;
}

/* Of the mean over batches. */
static double error_of(const struct light_sum *sum, double batches) {
    double mean = sum->sum / batches;
    double spread = sum->square / batches - mean * mean;
    return batches > 1 ? sqrt(fmax(spread, 0) / (batches - 1)) : 0;
}

/* Of the mean albedo. Darker pixels tell nothing by their few samples of it: the plain mean stands
 * in. */
static const double least_albedo = 1e-3;

static void develop_caustic(const struct light_pixel *pixel, double batches, const float *common,
                            float *channels) {
    for (int c = 0; c < 3; c++) {
        double albedo = (double)common[CHANNEL_ALBEDO + c], alpha = (double)common[CHANNEL_ALPHA];
        double mean = pixel->caustic[c].sum / batches,
               error = error_of(&pixel->caustic[c], batches);
        double scale = albedo > least_albedo ? 1 / albedo : 0;
        if (albedo <= least_albedo && alpha > 0 && mean > 0)
            scale = pixel->plain[c] / batches / alpha / mean;
        channels[CAUSTIC_LIGHT + c] = (float)(mean * scale);
        channels[CAUSTIC_STANDARD_ERROR + c] = (float)(error * scale);
    }
}

static void develop_volume(const struct light_pixel *pixel, double batches, float *channels) {
    for (int c = 0; c < 3; c++) {
        channels[VOLUME_LIGHT + c] = (float)(pixel->volume[c].sum / batches);
        channels[VOLUME_STANDARD_ERROR + c] = (float)error_of(&pixel->volume[c], batches);
    }
}

double light_film_develop(const struct light_film *film, bool has_medium, struct image *image) {
    int first = image->channel_count;
    double batches = film->batches, mean = 0, variance = 0;
    size_t count = (size_t)film->width * (size_t)film->height;
    image_add_channels(image, CHANNELS_OF_CAUSTIC);
    if (has_medium)
        image_add_channels(image, CHANNELS_OF_VOLUME);
    for (size_t i = 0; i < count; i++) {
        const struct light_pixel *pixel = &film->pixels[i];
        float *channels = image->pixels + i * (size_t)image->channel_count;
        develop_caustic(pixel, batches, channels, channels + first);
        if (has_medium)
            develop_volume(pixel, batches, channels + first + CAUSTIC_END);
        for (int c = 0; c < 3; c++) {
            channels[CHANNEL_BEAUTY + c] += (float)(pixel->beauty[c] / batches);
            mean += (pixel->caustic[c].sum + pixel->volume[c].sum) / batches;
            variance += pow(error_of(&pixel->caustic[c], batches), 2) +
                        pow(error_of(&pixel->volume[c], batches), 2);
        }
    }
    return mean > 0 ? sqrt(variance * 3 * (double)count) / mean : 0;
}
