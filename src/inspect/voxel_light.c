#include "inspect/voxel_light.h"

#include "gl/api.h"
#include "passes/frame.h"
#include "techniques/volume.h"

#include <math.h>
#include <string.h>

/* --- harmonics -------------------------------------------------------------------------------- */

static void harmonics_at(const float d[3], float y[VOXEL_LIGHT_COEFFICIENTS]) {
    const float xy = 1.0925484F;
    y[0] = .2820948F;
    y[1] = .4886025F * d[1];
    y[2] = .4886025F * d[2];
    y[3] = .4886025F * d[0];
    y[4] = xy * d[0] * d[1];
    y[5] = xy * d[1] * d[2];
    y[6] = .3153916F * (3 * d[2] * d[2] - 1);
    y[7] = xy * d[0] * d[2];
    y[8] = .5462742F * (d[0] * d[0] - d[1] * d[1]);
}

void voxel_light_radiance(const struct voxel_light *light, const float direction[3], float rgb[3]) {
    float y[VOXEL_LIGHT_COEFFICIENTS];
    harmonics_at(direction, y);
    memset(rgb, 0, 3 * sizeof *rgb);
    for (int i = 0; i < light->order * light->order; i++)
        for (int c = 0; c < 3; c++)
            rgb[c] += y[i] * light->coefficients[i][c];
}

/* --- the voxel -------------------------------------------------------------------------------- */

static bool texel_of(const struct volume_grid *grid, const int voxel[3], int texel[2]) {
    int columns = 1 << grid->columns_log2;
    for (int c = 0; c < 3; c++)
        if (voxel[c] < 0 || voxel[c] >= grid->cells[c])
            return false;
    texel[0] = voxel[2] % columns * grid->cells[0] + voxel[0];
    texel[1] = voxel[2] / columns * grid->cells[1] + voxel[1];
    return true;
}

static void read_texel(const struct texture *texture, const int texel[2], float rgba[4]) {
    gl.GetTextureSubImage(texture->id, 0, texel[0], texel[1], 0, 1, 1, 1, GL_RGBA, GL_FLOAT,
                          4 * sizeof *rgba, rgba);
}

/* As volume_is_read of glsl/lib/volume_distances.glsl, but for occupied voxels. */
static bool is_read(const struct volume *volume, const int texel[2]) {
    float rgba[4];
    read_texel(&volume->distances[0], texel, rgba);
    int code = (int)lrintf(255 * rgba[0]);
    return code >= 1 && code <= VOLUME_SHELL;
}

/* The one that is read among a place's voxel and its neighbours, nearest to the place; in voxels from the corner. */
static bool find_voxel(const struct volume *volume, const float place[3], int found[3]) {
    float least = INFINITY;
    for (int i = 0; i < 27; i++) {
        int step[3] = {i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1}, voxel[3], texel[2];
        float away = 0;
        for (int c = 0; c < 3; c++) {
            voxel[c] = (int)floorf(place[c]) + step[c];
            away += powf((float)voxel[c] + .5F - place[c], 2);
        }
        if (away < least && texel_of(&volume->grid, voxel, texel) && is_read(volume, texel)) {
            least = away;
            memcpy(found, voxel, sizeof voxel);
        }
    }
    return least < INFINITY;
}

/* --- its coefficients ------------------------------------------------------------------------- */

/* Textures of l <= 1 for each channel, of the next four for each, and one of the last for all. */
static void read_coefficients(struct voxel_light *light, const struct volume *volume,
                              const int texel[2], float unit) {
    float rgba[4];
    for (int i = 0; i < volume->coefficient_count; i++) {
        read_texel(&volume->coefficients[i], texel, rgba);
        for (int k = 0; k < 4; k++) {
            bool last = i == 2 * VOLUME_RADIANCE;
            if (!last)
                light->coefficients[4 * (i / VOLUME_RADIANCE) + k][i % VOLUME_RADIANCE] =
                    rgba[k] / unit;
            else if (k < VOLUME_RADIANCE)
                light->coefficients[VOXEL_LIGHT_COEFFICIENTS - 1][k] = rgba[k] / unit;
        }
    }
}

static const struct volume *volume_of(const struct renderer *renderer) {
    struct output_list outputs;
    renderer_outputs(renderer, &outputs);
    for (int i = 0; i < outputs.count; i++)
        if (outputs.items[i].kind == OUTPUT_VOXELS)
            return &((const struct volume_light *)outputs.items[i].source)->volume;
    return NULL;
}

void voxel_light_read(struct voxel_light *light, struct renderer *renderer, const float position[3],
                      const float normal[3]) {
    const struct volume *volume = volume_of(renderer);
    float place[3];
    int voxel[3], texel[2];
    *light = (struct voxel_light){0};
    if (!volume)
        return;
    const struct volume_grid *grid = &volume->grid;
    for (int c = 0; c < 3; c++)
        place[c] = (position[c] - grid->corner[c]) / grid->voxel + 1.5F * normal[c];
    if (!find_voxel(volume, place, voxel) || !texel_of(grid, voxel, texel))
        return;
    light->order = volume->desc.order;
    for (int c = 0; c < 3; c++)
        light->middle[c] = grid->corner[c] + grid->voxel * ((float)voxel[c] + .5F);
    read_coefficients(light, volume, texel, renderer_frame(renderer).irradiance_scale);
}
