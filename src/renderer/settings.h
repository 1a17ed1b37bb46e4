/* All settings of the renderer: the parts of every technique and direct method, and of the
 * picture. */
#ifndef RENDERER_SETTINGS_H
#define RENDERER_SETTINGS_H

#include "base/settings.h"
#include "techniques/technique.h"

enum { EXPOSURE_MOST = 32 }; /* EV, both signs */

struct picture_settings {
    float exposure; /* EV */
    int samples;    /* samples of a pixel, for antialiasing */
    int tone_map;   /* enum tone_map */
};

extern const struct settings_part picture_part;

/* Sets every part to its defaults. */
void renderer_settings_init(struct settings *settings);

/* Assigns texts, each "name=value", or several separated by spaces or commas. "path=NAME" selects
 * the technique's preset of that name or word. Presets apply first, wherever they stand, and
 * count as defaults; other values count as given (settings_give_word). Error: unknown name or bad
 * value. */
bool renderer_settings_assign(struct settings *settings, const struct technique *technique,
                              const char *const *texts, int count);

/* Returns the settings with automatic values replaced by the technique's values for the scene. */
struct settings renderer_settings_chosen(const struct settings *settings,
                                         const struct technique *technique,
                                         const struct scene *scene,
                                         const struct geometry *geometry);

/* True if all `parts` are equal in both. */
bool renderer_settings_same(const struct settings *a, const struct settings *b,
                            const struct settings_part *const *parts);

/* renderer_settings_roughen turns antialiasing off, for pictures during motion.
 * renderer_settings_copy_but_samples copies all settings except the samples. */
void renderer_settings_roughen(struct settings *settings);
void renderer_settings_copy_but_samples(struct settings *to, const struct settings *from);

/* True if the setting changes pictures of the technique, by the `needs` of its row. An effect that
 * needs another technique's settings does not count. */
bool setting_matters(const struct setting *setting, const struct settings *settings,
                     const struct technique *technique);

/* Prints settings for --help: the technique's presets and main settings. all: every setting of the
 * technique, the direct methods and the picture. */
void renderer_settings_print_help(FILE *out, const struct technique *technique, bool all);

#endif
