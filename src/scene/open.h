/* Opens a file as a scene that is ready to render. */
#ifndef SCENE_OPEN_H
#define SCENE_OPEN_H

#include "scene/choice.h"
#include "scene/lights/environment.h"
#include "scene/mesh/geometry.h"

struct scene_open_desc {
    struct scene *filled; /* a scene that takes the file's place; it is left zeroed. NULL: none */
    struct scene_choice choice;
    const char *light; /* lights, as in scene/placing.h; NULL: all */
    const char *clip;  /* clips, as in scene/clips.h; NULL: the default */
    struct environment_desc environment;
    float punctual_scale; /* as in scene/lights/punctual.h; 0: 1 */
    bool may_be_empty;    /* opens a scene without triangles; its geometry stays zeroed */
};

/* Loads the file with the changes of `desc` (NULL: none) and lays out the triangles of time 0. A
 * scene far from the origin is moved there (scene/recentre.h). Missing camera and lights are added
 * (scene/framing.h, scene/darkness.h), but no lights if desc->light names all. Triangles are laid
 * out once; twice far from the origin; once more for dark scenes. Error: names file, object and
 * reason; both are then zeroed. */
bool scene_open(struct scene *scene, struct geometry *geometry, const char *path,
                const struct scene_open_desc *desc);

#endif
