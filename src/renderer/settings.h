/* All settings of the renderer: the parts of every technique and direct method, and the picture's
 * own. */
#ifndef RENDERER_SETTINGS_H
#define RENDERER_SETTINGS_H

#include "base/settings.h"
#include "techniques/technique.h"

enum { EXPOSURE_MOST = 32 }; /* EV, up and down */

struct picture_settings {
    float exposure; /* EV */
    int samples;    /* of the pixel's area, for its edges */
    int tone_map;   /* enum tone_map */
};

extern const struct settings_part picture_part;

/* Every part with its defaults. */
void renderer_settings_init(struct settings *settings);

/* Assigns texts, each "name=value" or several with spaces or commas between. "path=NAME" stands for
 * a preset of the technique by its name or its word; presets come first, wherever they stand, and count as the program's: all else
 * is given (settings_give_word). Error: of a name or a value. */
bool renderer_settings_assign(struct settings *settings, const struct technique *technique,
                              const char *const *texts, int count);

/* The settings with the technique's numbers for the scene in place of values that leave a choice to the program. */
struct settings renderer_settings_chosen(const struct settings *settings,
                                         const struct technique *technique,
                                         const struct scene *scene,
                                         const struct geometry *geometry);

/* Whether all of the parts are the same in both. */
bool renderer_settings_same(const struct settings *a, const struct settings *b,
                            const struct settings_part *const *parts);

/* A picture with rough edges, for while things move; and all of a picture's settings but how rough
 * its edges are. */
void renderer_settings_roughen(struct settings *settings);
void renderer_settings_copy_but_samples(struct settings *to, const struct settings *from);

/* Whether the setting changes pictures of the technique, by what its row needs: an effect that only another technique's
 * settings could give is none. */
bool setting_matters(const struct setting *setting, const struct settings *settings,
                     const struct technique *technique);

/* For --help: the technique's presets, and its main settings, or all of its own, the direct methods' and the picture's. */
void renderer_settings_print_help(FILE *out, const struct technique *technique, bool all);

#endif
