#include "passes/volumes.h"

#include "base/memory.h"
#include "gl/framebuffer.h"
#include "passes/frame.h"

#include <math.h>
#include <string.h>

enum { MARGIN = 2 }; /* voxels around the box, from which surfaces at its sides read */

void volume_grid_fit(struct volume_grid *grid, const struct volume_desc *desc) {
    float longest = 1e-6F; /* metres: the bounds are a point where all metaballs have vanished */
    *grid = (struct volume_grid){0};
    for (int c = 0; c < 3; c++)
        longest = fmaxf(longest, desc->high[c] - desc->low[c]);
    grid->voxel = longest / (float)(desc->size - 2 * MARGIN - 1);
    for (int c = 0; c < 3; c++) {
        /* Half a voxel of room at each end, so that walls at the sides do not lie between two
         * voxels. */
        float extent = (desc->high[c] - desc->low[c]) / grid->voxel;
        grid->cells[c] = (int)ceilf(extent - 1e-3F) + 1 + 2 * MARGIN;
        grid->corner[c] =
            (desc->low[c] + desc->high[c]) / 2 - (float)grid->cells[c] / 2 * grid->voxel;
    }
    while (1 << (2 * grid->columns_log2) < grid->cells[2])
        grid->columns_log2++;
    int columns = 1 << grid->columns_log2;
    grid->width = columns * grid->cells[0];
    grid->height = (grid->cells[2] + columns - 1) / columns * grid->cells[1];
}

static int coefficient_count(const struct volume_desc *desc) {
    return desc->channels * (desc->order - 1) + (desc->order == 3);
}

bool volume_is_split(const struct volume_desc *desc) {
    return desc->channels == VOLUME_RADIANCE && !desc->published;
}

double volume_bytes(const struct volume_desc *desc) {
    const double sum = 16, distance = 1, coefficients = 8;
    struct volume_grid grid;
    volume_grid_fit(&grid, desc);
    bool light = desc->channels == VOLUME_RADIANCE, split = volume_is_split(desc);
    int sums = 1 + light + (light && desc->both_sides) + 2 * split +
               (light && desc->bounces) * (2 + desc->both_sides + split);
    return (double)grid.width * grid.height *
           (sum * sums + 2 * distance + coefficients * (coefficient_count(desc) + 1));
}

static bool init_texture(const struct volume *volume, struct texture *texture, const char *label,
                         GLenum format) {
    return texture_init(texture, &(struct texture_desc){.label = label,
                                                        .format = format,
                                                        .width = volume->grid.width,
                                                        .height = volume->grid.height});
}

static bool init_points(struct volume *volume) {
    const struct volume_desc *desc = &volume->desc;
    struct framebuffer_desc target = {.label = "volume points", .colors = {&volume->surfaces}};
    int count = 1;
    bool ok = init_texture(volume, &volume->surfaces, "volume surfaces", GL_RGBA32F);
    bool split = volume_is_split(desc);
    struct texture *others[] = {&volume->radiosity, desc->both_sides ? &volume->back : NULL,
                                desc->bounces ? &volume->albedo : NULL,
                                split ? &volume->turned_surfaces : NULL,
                                split ? &volume->turned_radiosity : NULL};
    for (size_t i = 0; desc->channels == VOLUME_RADIANCE && i < sizeof others / sizeof *others; i++)
        if (others[i]) {
            ok = ok && init_texture(volume, others[i], "volume sums", GL_RGBA32F);
            target.colors[count++] = others[i];
        }
    return ok && framebuffer_init(&volume->points_framebuffer, &target);
}

static bool init_distances(struct volume *volume) {
    bool ok = true;
    for (int i = 0; ok && i < 2; i++)
        ok = framebuffer_init_target(&volume->distances[i], &volume->distance_framebuffers[i],
                                     &(struct texture_desc){.label = "volume distances",
                                                            .format = GL_R8,
                                                            .width = volume->grid.width,
                                                            .height = volume->grid.height});
    return ok;
}

static bool init_coefficients(struct volume *volume) {
    struct framebuffer_desc all = {.label = "volume coefficients"};
    int count = volume->coefficient_count;
    bool ok = true;
    for (int i = 0; ok && i < count; i++)
        ok = framebuffer_init_target(&volume->coefficients[i], &volume->smooth_framebuffers[i],
                                     &(struct texture_desc){.label = all.label,
                                                            .format = GL_RGBA16F,
                                                            .width = volume->grid.width,
                                                            .height = volume->grid.height});
    ok = ok && init_texture(volume, &volume->coefficients[count], all.label, GL_RGBA16F);
    for (int i = 0; i < count; i++)
        all.colors[i] = &volume->coefficients[i + 1];
    return ok && framebuffer_init(&volume->march_framebuffer, &all);
}

bool volume_init(struct volume *volume, const struct volume_desc *desc) {
    *volume = (struct volume){.desc = *desc, .coefficient_count = coefficient_count(desc)};
    volume_grid_fit(&volume->grid, desc);
    if (init_points(volume) && init_distances(volume) && init_coefficients(volume))
        return true;
    volume_free(volume);
    return false;
}

void volume_free(struct volume *volume) {
    framebuffers_free(&volume->points_framebuffer, &volume->march_framebuffer);
    textures_free(&volume->surfaces, &volume->radiosity, &volume->back, &volume->albedo,
                  &volume->turned_surfaces, &volume->turned_radiosity);
    for (int i = 0; i < 2; i++) {
        framebuffer_free(&volume->distance_framebuffers[i]);
        texture_free(&volume->distances[i]);
    }
    for (int i = 0; i < VOLUME_COEFFICIENTS_MAX; i++)
        framebuffer_free(&volume->smooth_framebuffers[i]);
    for (int i = 0; i <= VOLUME_COEFFICIENTS_MAX; i++)
        texture_free(&volume->coefficients[i]);
    *volume = (struct volume){0};
}

char *volume_defines(const struct volume *volume) {
    const struct volume_desc *desc = &volume->desc;
    bool light = desc->channels == VOLUME_RADIANCE;
    return mem_printf(
        "%sCHANNELS %d;ORDER %d;COEFFICIENTS %d;BACKS %d;BOUNCES %d;BOTH_SIDES %d;PUBLISHED %d;"
        "SPLIT %d",
        light_defines(desc->medium, false), desc->channels, desc->order, volume->coefficient_count,
        light && desc->both_sides, light && desc->bounces, desc->both_sides, desc->published,
        volume_is_split(desc));
}

struct volume_params volume_params_of(const struct volume *volume) {
    const struct volume_grid *grid = &volume->grid;
    struct volume_params params = {
        .voxel = grid->voxel,
        .columns_log2 = grid->columns_log2,
        .irradiance_scale = 1,
        .atlas = {(float)grid->width, (float)grid->height},
    };
    memcpy(params.corner, grid->corner, sizeof grid->corner);
    for (int c = 0; c < 3; c++)
        params.cells[c] = (float)grid->cells[c];
    return params;
}
