/* A volume's voxels as the camera sees them: the radiosity of the first occupied voxel at each pixel. */
#ifndef TECHNIQUES_IMPERFECT_VOLUME_VOXELS_H
#define TECHNIQUES_IMPERFECT_VOLUME_VOXELS_H

#include "passes/targets.h"
#include "techniques/volume.h"

struct voxel_view {
    GLuint program;
    char *defines; /* what the program is made for */
    struct irradiance picture;
};

/* For a volume of radiance. Error: GPU memory, shader; it is then zeroed. */
bool voxel_view_fit(struct voxel_view *view, const struct volume_light *light, int width,
                    int height);

/* Accepts a zeroed one. */
void voxel_view_free(struct voxel_view *view);

/* Into view->picture, radiosity times irradiance_scale. The G-buffer is of the picture's size. */
void voxel_view_draw(const struct voxel_view *view, const struct frame *frame,
                     const struct gbuffer *gbuffer, const struct volume_light *light);

#endif
