/* What a picture is taken of: a scene's triangles at one time, one of its cameras, its lights or
 * some of them. */
#ifndef RENDERER_STAGE_H
#define RENDERER_STAGE_H

#include "renderer/renderer.h"
#include "scene/camera.h"
#include "scene/lights/emitter.h"
#include "scene/lights/environment.h"
#include "scene/mesh/geometry.h"

struct stage_desc {
    const char *path;
    const struct file_bytes
        *bytes; /* in place of the file, as of scene_load_bytes; NULL = the file */
    struct scene_choice choice;
    const char *camera, *light; /* as scene/placing.h has it; NULL = the first, and all; must live
                                   on */
    const char *clip;           /* as scene/clips.h has it; NULL = the default */
    struct environment_desc environment;
    float punctual_scale; /* of intensities: scene/lights/punctual.h */
    float time;           /* of the animation, seconds */
};

struct stage {
    char name[SCENE_NAME_SIZE]; /* the file's, without folder, leading dots and extension */
    struct scene scene;
    struct geometry geometry;
    struct camera camera;
    struct emitters emitters;
    const char *camera_text, *light_text;
};

/* Error: of the file, or no such camera, light or clip; the stage is then zeroed. */
bool stage_init(struct stage *stage, const struct stage_desc *desc);

/* Moves triangles, camera and lights to where they are at a time. Error: geometry_pose's. */
bool stage_pose(struct stage *stage, double time);
void stage_free(struct stage *stage);

/* The size of a picture of its camera where none is asked for: camera_default_size. */
void stage_default_size(const struct stage *stage, int size[2]);

/* Whether the renderer, which is of this stage, now shows it as it is posed. Error: the renderer
 * must then be freed. */
bool stage_show(const struct stage *stage, struct renderer *renderer);

#endif
