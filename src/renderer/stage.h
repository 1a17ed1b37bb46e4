/* A stage: a scene's triangles at one time, one of its cameras, and all or some of its lights. */
#ifndef RENDERER_STAGE_H
#define RENDERER_STAGE_H

#include "renderer/renderer.h"
#include "scene/camera.h"
#include "scene/lights/emitter.h"
#include "scene/lights/environment.h"
#include "scene/mesh/geometry.h"
#include "scene/surface_layers.h"

struct stage_desc {
    const char *path;
    struct scene *filled; /* as in struct scene_open_desc */
    struct scene_choice choice;
    /* Texts of scene/placing.h; NULL: the first camera, all lights. They must outlive the stage. */
    const char *camera, *light;
    const char *clip; /* as in scene/clips.h; NULL: the default */
    struct environment_desc environment;
    float punctual_scale; /* factor of intensities (scene/lights/punctual.h) */
    float time;           /* time of the animation, seconds */
};

struct stage {
    char name[SCENE_NAME_SIZE]; /* name of the file without folder, leading dots and extension */
    struct scene scene;
    struct geometry geometry;
    struct camera camera;
    struct emitters emitters;
    const char *camera_text, *light_text;
};

/* Error: that of the file, or an unknown camera, light or clip; the stage is then zeroed. */
bool stage_init(struct stage *stage, const struct stage_desc *desc);

/* Moves triangles, camera and lights to a time, seconds. Error: that of geometry_pose. */
bool stage_pose(struct stage *stage, double time);
void stage_free(struct stage *stage);

/* Finds where vertices and the camera of its text are `step` seconds after and before `time`, the
 * time of its pose, which returns. Surfaces of metaballs keep their places. Times below 0 are 0.
 * Error: that of geometry_pose; free the motion in any case. */
bool stage_find_motion(struct stage *stage, double time, double step,
                       struct surface_motion *motion);

/* Writes the default size of a picture of its camera: that of its intrinsics, or of
 * camera_default_size. */
void stage_default_size(const struct stage *stage, int size[2]);

/* Updates the renderer of this stage to its pose. Error: that of renderer_update; the caller must
 * then free the renderer. */
bool stage_show(const struct stage *stage, struct renderer *renderer);

#endif
