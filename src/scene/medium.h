/* The participating medium that a picture shows: the one of the scene's file, or one of the user's settings. */
#ifndef SCENE_MEDIUM_H
#define SCENE_MEDIUM_H

#include "base/settings.h"
#include "scene/scene.h"

struct medium_settings {
    float scatter, absorb; /* optical depth of the scene's radius; both 0: the scene's medium */
    float g;
    bool scene;
    int steps; /* of the airlight of one light along a pixel's ray */
};

extern const struct settings_part medium_part;

/* Whether it scatters or absorbs. */
bool medium_exists(const struct medium *medium);

/* The medium that the settings choose for a scene of that radius, metres. */
struct medium medium_of(const struct scene *scene, const struct settings *settings, float radius);

#endif
