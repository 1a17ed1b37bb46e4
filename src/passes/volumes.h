/* A volume: cubic voxels over a box, with the surfaces in them and the light that arrives between them [Mavridis and
 * Papaioannou 2011].
 *
 * Each texture is an atlas of the volume's slices (lib/volume.glsl): passes draw all voxels at once as pixels of a plane,
 * and points as pixels.
 */
#ifndef PASSES_VOLUMES_H
#define PASSES_VOLUMES_H

#include "gl/buffer.h"
#include "gl/texture.h"
#include "shared/volume.h"

struct volume_desc {
    int size; /* voxels along the box's longest side, with a margin of two at each end */
    float low[3], high[3]; /* of what is in the box, metres */
    int channels;          /* VOLUME_VISIBILITY or VOLUME_RADIANCE */
    int order;             /* of the spherical harmonics: 2 or 3 */
    bool both_sides;       /* some surfaces are seen, and reflect, from both sides */
    bool published;        /* emission, rays and reconstruction are the paper's */
    bool bounces;          /* light is reflected again: albedos are kept */
    bool medium;           /* frames have one, or panes */
};

/* Where voxels lie. */
struct volume_grid {
    float corner[3], voxel; /* of the first voxel, and a voxel's side, metres */
    int cells[3];
    int columns_log2; /* slices in a row of the atlas */
    int width, height;
};

struct volume {
    struct volume_desc desc;
    struct volume_grid grid;
    /* Sums over a voxel's points: normal and count; radiosity of the front, and of the back with how many have one,
     * times irradiance_scale; albedo. Radiosity's alpha: how far planes are from the voxel's middle. */
    struct texture surfaces, radiosity, back, albedo;
    /* Surfaces and radiosity of the points alone that are turned away from a direction (src/passes/volume/point_sums.glsl): in
     * voxels whose surfaces face several ways they are one side. Where volume_is_split. */
    struct texture turned_surfaces, turned_radiosity;
    GLuint points_framebuffer;
    /* R8, over 255: voxels to the nearest occupied one; and of those that surfaces read how many neighbours they have. */
    struct texture distances[2];
    GLuint distance_framebuffers[2];
    /* RGBA16F, of each channel l <= 1, then the next four, then the last ones together: the first coefficient_count are
     * to be read. The march draws into the next ones, and smoothing moves each to the one before. */
    struct texture coefficients[VOLUME_COEFFICIENTS_MAX + 1];
    GLuint march_framebuffer, smooth_framebuffers[VOLUME_COEFFICIENTS_MAX];
    int coefficient_count;
};

void volume_grid_fit(struct volume_grid *grid, const struct volume_desc *desc);

/* Whether voxels keep two sides: the light of visibility, and of the paper, does not know them. */
bool volume_is_split(const struct volume_desc *desc);

/* Of all textures, bytes. */
double volume_bytes(const struct volume_desc *desc);

/* Error: out of GPU memory. */
bool volume_init(struct volume *volume, const struct volume_desc *desc);
void volume_free(struct volume *volume);

/* Defines for its shaders; to be freed. */
char *volume_defines(const struct volume *volume);

/* What shaders need to find voxels. */
struct volume_params volume_params_of(const struct volume *volume);

#endif
