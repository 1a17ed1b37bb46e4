/* Volumes: cubic voxels over a box with their surfaces and the light between them [Mavridis and
 * Papaioannou 2011].
 *
 * Each texture is an atlas of the volume's slices (lib/volume.glsl). Passes draw all voxels at once
 * as pixels of a plane, and points as single pixels. */
#ifndef PASSES_VOLUMES_H
#define PASSES_VOLUMES_H

#include "gl/buffer.h"
#include "gl/texture.h"
#include "shared/volume.h"

struct volume_desc {
    int size; /* voxels along the box's longest side, with a margin of two at each end */
    float low[3], high[3]; /* bounds of the contents, metres */
    int channels;          /* VOLUME_VISIBILITY or VOLUME_RADIANCE */
    int order;             /* order of the spherical harmonics: 2 or 3 */
    bool both_sides;       /* some surfaces reflect from both sides */
    bool published;        /* emission, rays and reconstruction as in the paper */
    bool bounces;          /* keeps albedos, to reflect light again */
    bool medium;           /* frames have a medium or panes */
};

/* Positions of the voxels. */
struct volume_grid {
    float corner[3], voxel; /* corner of the first voxel and side of a voxel, metres */
    int cells[3];
    int columns_log2; /* binary logarithm of the slices in a row of the atlas */
    int width, height;
};

struct volume {
    struct volume_desc desc;
    struct volume_grid grid;
    /* Sums over a voxel's points: normal, count; front radiosity; back radiosity and the count of
     * points with one; albedo. Radiosity is times irradiance_scale; its alpha is the planes'
     * distance from the voxel's centre. */
    struct texture surfaces, radiosity, back, albedo;
    /* Sums over points turned away from a direction (src/passes/volume/inject.vert): the second
     * side of voxels with several orientations. Only with volume_is_split. */
    struct texture turned_surfaces, turned_radiosity;
    GLuint points_framebuffer;
    /* R8, over 255: voxels to the nearest occupied one; neighbours that are read as well, for
     * voxels that surfaces read. */
    struct texture distances[2];
    GLuint distance_framebuffers[2];
    /* RGBA16F: for each channel l <= 1, then the next four, then the last ones together. The first
     * coefficient_count are read. The march draws into the ones after the first; smoothing moves
     * each one back. */
    struct texture coefficients[VOLUME_COEFFICIENTS_MAX + 1];
    GLuint march_framebuffer, smooth_framebuffers[VOLUME_COEFFICIENTS_MAX];
    int coefficient_count;
};

void volume_grid_fit(struct volume_grid *grid, const struct volume_desc *desc);

/* True if voxels keep two sides. Visibility volumes and the published variant do not. */
bool volume_is_split(const struct volume_desc *desc);

/* Returns the size of all textures, bytes. */
double volume_bytes(const struct volume_desc *desc);

/* Error: out of GPU memory. */
bool volume_init(struct volume *volume, const struct volume_desc *desc);
void volume_free(struct volume *volume);

/* Returns defines for the volume's shaders. The caller frees them. */
char *volume_defines(const struct volume *volume);

/* Returns the parameters by which shaders find voxels. */
struct volume_params volume_params_of(const struct volume *volume);

#endif
