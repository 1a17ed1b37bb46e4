/* Light that smooth surfaces throw onto others: what a user asks for. */
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
    int chains;   /* of each ray through glass */
    float step;   /* as published: between steps of a pixel's ray, metres */
    float kernel; /* as published: the Gaussian's support over the step */
};

extern const struct settings_part caustics_part;

/* Whether the settings ask for any, in a medium where there is one, materials are not all diffuse, and a mesh has a smooth
 * material. Such a surface then scatters no light. */
bool caustics_shown(const struct scene *scene, const struct settings *settings);

/* Notes that light goes straight on through the scene's solid glass, where it has some. */
void caustics_note_straight(const struct scene *scene);

#endif
