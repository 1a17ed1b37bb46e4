/* Describes and applies presets of a technique. */
#ifndef VIEWER_PRESET_H
#define VIEWER_PRESET_H

#include "renderer/settings.h"

enum { PRESET_TITLE_SIZE = 24, PRESET_HELP_SIZE = 320 };

/* Writes the word of --quality, or the preset's name, with a capital. */
void preset_title(const struct preset *preset, char title[PRESET_TITLE_SIZE]);

/* Writes its purpose, its time and error against Normal, and its options on the command line. */
void preset_explain(const struct preset *preset, char text[PRESET_HELP_SIZE]);

/* Copies exposure and tone map from `now`: they are no part of a preset. */
void preset_keep_tone(struct settings *settings, const struct settings *now);

/* Returns the settings of a preset, or the defaults if NULL, with preset_keep_tone. */
struct settings preset_settings(const struct preset *preset, const struct settings *now);

#endif
