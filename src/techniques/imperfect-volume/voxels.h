/* Draws a volume's voxels from the camera: the radiosity of the first occupied voxel at each
 * pixel. */
#ifndef TECHNIQUES_IMPERFECT_VOLUME_VOXELS_H
#define TECHNIQUES_IMPERFECT_VOLUME_VOXELS_H

#include "passes/targets.h"
#include "techniques/volume.h"

struct voxel_view {
    GLuint program;
    char *defines; /* defines of the program */
    struct irradiance picture;
    bool drawn; /* the picture is that of the last frame */
};

/* Makes program and picture for a volume of radiance. Error: GPU memory, shader; view is then
 * zeroed. */
bool voxel_view_fit(struct voxel_view *view, const struct volume_light *light, int width,
                    int height);

/* Accepts a zeroed view. */
void voxel_view_free(struct voxel_view *view);

/* Draws radiosity times irradiance_scale into view->picture. The G-buffer has the picture's
 * size. */
void voxel_view_draw(const struct voxel_view *view, const struct frame *frame,
                     const struct gbuffer *gbuffer, const struct volume_light *light);

#endif
