/* Presets of a technique as the viewer has them. */
#ifndef VIEWER_PRESET_H
#define VIEWER_PRESET_H

#include "renderer/settings.h"

enum { PRESET_TITLE_SIZE = 24, PRESET_HELP_SIZE = 320 };

/* The word of --quality or its name, with a capital. */
void preset_title(const struct preset *preset, char title[PRESET_TITLE_SIZE]);

/* Writes for which pictures it is, its time and error against Normal, and its words on the command
 * line. */
void preset_explain(const struct preset *preset, char text[PRESET_HELP_SIZE]);

/* Exposure and tone map as they are: they are no part of how well a picture is made. */
void preset_keep_tone(struct settings *settings, const struct settings *now);

/* All settings by a preset, or without one (NULL) the defaults, with preset_keep_tone. */
struct settings preset_settings(const struct preset *preset, const struct settings *now);

#endif
