/* The participating medium of a picture: that of the scene's file or of the settings. */
#ifndef SCENE_MEDIUM_H
#define SCENE_MEDIUM_H

#include "base/settings.h"
#include "scene/scene.h"

struct medium_settings {
    float scatter, absorb; /* optical depth over the scene's radius; both 0: the scene's medium */
    float g;
    bool scene;
    int steps; /* airlight steps of one light along a pixel's ray */
};

extern const struct settings_part medium_part;

/* True if the medium scatters or absorbs. */
bool medium_exists(const struct medium *medium);

/* Returns the medium for a scene of `radius`, metres. */
struct medium medium_of(const struct scene *scene, const struct settings *settings, float radius);

#endif
