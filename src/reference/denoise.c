#include "reference/denoise.h"

#include "reference/atrous.h"
#include "reference/channels.h"
#include "reference/vector.h"

#include "base/memory.h"

#include <math.h>

/* Below, the noise of a pixel is too far from Gaussian to compare by its variance. */
enum { FEW_PATHS = 16 };

static size_t pixel_count(const struct denoise_desc *desc) {
    return (size_t)desc->primary->width * (size_t)desc->primary->height;
}

static struct atrous_guide *make_guides(const struct denoise_desc *desc) {
    size_t count = pixel_count(desc);
    struct atrous_guide *guides = mem_alloc(count, sizeof *guides);
    for (size_t i = 0; i < count; i++) {
        const struct film_pixel *pixel = &desc->pixels[i];
        if (pixel->coverage == 0)
            continue;
        vec3s position = glms_vec3_scale(vector_of(pixel->position), 1 / pixel->coverage);
        float depth = primary_depth(desc->primary, position);
        guides[i] = (struct atrous_guide){
            .position = position,
            .normal = vec3s_unit(vector_of(pixel->normal)),
            .pixel_size = primary_pixel_size(desc->primary, depth),
        };
    }
    atrous_find_lonely(desc->primary->width, desc->primary->height, guides);
    return guides;
}

/* The noise of the channels is that of the same paths: their standard errors add up. */
static struct atrous_pixel light_of(const struct film_pixel *pixel) {
    struct film_estimate estimate = film_pixel_estimate(pixel);
    struct atrous_pixel light;
    double error = 0;
    for (int c = 0; c < 3; c++) {
        light.light.raw[c] = (float)estimate.mean[c];
        error += sqrt(estimate.variance[c]) / 3;
    }
    light.variance = (float)(error * error);
    return light;
}

static void filter(const struct denoise_desc *desc, const struct atrous_guide *guides,
                   struct atrous_pixel *light) {
    struct atrous_desc atrous = {
        .width = desc->primary->width,
        .height = desc->primary->height,
        .guides = guides,
        .levels = 5,
        .blind_levels = desc->samples * desc->paths < FEW_PATHS ? 1 : 0,
        .threads = desc->threads,
    };
    for (size_t i = 0; i < pixel_count(desc); i++)
        light[i] = light_of(&desc->pixels[i]);
    atrous_estimate_variance(&atrous, desc->samples > 1, light);
    atrous_filter(&atrous, light);
}

/* Radiance that leaves the surfaces. */
static float surface_radiance(const struct denoise_desc *desc, const float *channels, int c) {
    float light = channels[CHANNEL_DIRECT + c] + channels[CHANNEL_INDIRECT + c];
    float sum = channels[CHANNEL_ALBEDO + c] * light + channels[CHANNEL_EMITTED + c];
    return desc->specular_channel ? sum + channels[desc->specular_channel + SPECULAR_ALL + c] : sum;
}

/* A medium passes as much of the filtered light as of the light before. */
static void write_light(const struct denoise_desc *desc, const struct atrous_pixel *light,
                        float *channels) {
    for (int c = 0; c < 3; c++) {
        float *beauty = &channels[CHANNEL_BEAUTY + c], before = surface_radiance(desc, channels, c);
        channels[CHANNEL_INDIRECT + c] = light->light.raw[c];
        float after = surface_radiance(desc, channels, c);
        if (!desc->airlight_channel) {
            *beauty = after;
        } else if (before > 0) {
            float airlight = channels[desc->airlight_channel + AIRLIGHT_RADIANCE + c];
            *beauty = airlight + (*beauty - airlight) * after / before;
        }
    }
}

void denoise(const struct denoise_desc *desc, struct image *image) {
    struct atrous_guide *guides = make_guides(desc);
    struct atrous_pixel *light = mem_alloc(pixel_count(desc), sizeof *light);
    filter(desc, guides, light);
    for (size_t i = 0; i < pixel_count(desc); i++)
        write_light(desc, &light[i], &image->pixels[i * (size_t)image->channel_count]);
    mem_free(light, guides);
}
