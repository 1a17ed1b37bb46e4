/* Presets of a technique as the viewer has them. */
#ifndef VIEWER_PRESET_H
#define VIEWER_PRESET_H

#include "renderer/settings.h"

/* As people call it. */
const char *preset_title(const struct preset *preset);

/* Exposure and tone map as they are: they are no part of how well a picture is made. */
void preset_keep_tone(struct settings *settings, const struct settings *now);

/* All settings by a preset, or without one (NULL) the defaults, with preset_keep_tone. */
struct settings preset_settings(const struct preset *preset, const struct settings *now);

#endif
