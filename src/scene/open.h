/* From a file to a scene that can be shown. */
#ifndef SCENE_OPEN_H
#define SCENE_OPEN_H

#include "scene/choice.h"
#include "scene/lights/environment.h"
#include "scene/mesh/geometry.h"

struct scene_open_desc {
    const struct file_bytes
        *bytes; /* in place of the file, as of scene_load_bytes; NULL = the file */
    struct scene_choice choice;
    const char *light; /* those that shine, as scene/placing.h has it; NULL = all */
    const char *clip;  /* those that play, as scene/clips.h has it; NULL = the default */
    struct environment_desc environment;
    float punctual_scale; /* as of scene/lights/punctual.h; 0 = 1 */
    bool may_be_empty;    /* a scene without triangles opens; its geometry stays zeroed */
};

/* Loads the file, changes of it what desc says, unless that is NULL, lays out the triangles of time
 * 0, moves all to the origin where it lies far out (scene/recentre.h) and gives it the camera and the
 * light that it lacks (scene/framing.h, scene/darkness.h), but no light where light names all that
 * shine. Triangles are laid out once; of scenes far out
 * twice, and once more of dark ones. Error: names file, object and reason; both are then zeroed. */
bool scene_open(struct scene *scene, struct geometry *geometry, const char *path,
                const struct scene_open_desc *desc);

#endif
