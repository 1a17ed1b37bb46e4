/* Settings of caustics, the light that smooth surfaces throw onto others. */
#ifndef SCENE_CAUSTICS_H
#define SCENE_CAUSTICS_H

#include "base/settings.h"
#include "scene/scene.h"

enum caustics_surface { CAUSTICS_OFF, CAUSTICS_PATCHES, CAUSTICS_POINTS };
enum caustics_volume { VOLUME_CAUSTICS_OFF, VOLUME_CAUSTICS_LINES, VOLUME_CAUSTICS_PAPER };

struct caustics_settings {
    int surface;  /* enum caustics_surface */
    int volume;   /* enum caustics_volume */
    int size;     /* rays a side of a light's view */
    int chains;   /* chains of each ray, with glass */
    float step;   /* published variant: step of a pixel's ray, metres */
    float kernel; /* published variant: support of the Gaussian, in steps */
};

extern const struct settings_part caustics_part;

/* True if the settings enable caustics, materials are not all diffuse, and a mesh has a smooth
 * material. Volume caustics also need a medium. Smooth surfaces then scatter no light. */
bool caustics_shown(const struct scene *scene, const struct settings *settings);

/* Logs that light passes straight through the scene's solid glass, if it has some. */
void caustics_note_straight(const struct scene *scene);

#endif
