#include "viewer/picture/preset.h"

#include "base/memory.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *word_of(const struct preset *preset) {
    return preset->word ? preset->word : preset->name;
}

void preset_title(const struct preset *preset, char title[PRESET_TITLE_SIZE]) {
    snprintf(title, PRESET_TITLE_SIZE, "%s", word_of(preset));
    if (title[0] >= 'a' && title[0] <= 'z')
        title[0] = (char)(title[0] - 'a' + 'A');
}

/* Of clustered: bench/FRONTS.md. */
static const struct price {
    const char *word, *use;
    const char *time, *error; /* against normal's; NULL: they are normal's */
} prices[] = {
    {"draft", "For slow machines and first looks", "x0.7 to x0.9 the time of Normal",
     "1.2 to 1.8 times its error"},
    {"normal", "For most scenes: the defaults", NULL, NULL},
    {"high", "The least error of a frame: 1024 VPLs", "x1.3 to x2.1 the time of Normal",
     "up to a fifth less error"},
};

static const struct price *price_of(const char *word) {
    for (size_t i = 0; i < sizeof prices / sizeof *prices; i++)
        if (strcmp(prices[i].word, word) == 0)
            return &prices[i];
    return NULL;
}

/* The caller frees it. */
static char *help_text(const struct preset *preset) {
    const struct price *price = price_of(word_of(preset));
    if (!price || !price->time)
        return mem_strdup(price ? price->use : preset->help);
    return mem_printf("%s. %s, and %s", price->use, price->time, price->error);
}

void preset_explain(const struct preset *preset, char text[PRESET_HELP_SIZE]) {
    char *help = help_text(preset);
    const char *word = word_of(preset);
    bool is_quality =
        strcmp(word, "draft") == 0 || strcmp(word, "normal") == 0 || strcmp(word, "high") == 0;
    snprintf(text, PRESET_HELP_SIZE, "%s. On the command line: %s%s.", help,
             is_quality ? "--quality " : "--set path=", word);
    free(help);
}

void preset_keep_tone(struct settings *settings, const struct settings *now) {
    const struct picture_settings *shown = settings_of(struct picture_settings, now, &picture_part);
    struct picture_settings picture =
        *settings_of(struct picture_settings, settings, &picture_part);
    picture.exposure = shown->exposure;
    picture.tone_map = shown->tone_map;
    settings_set(settings, &picture_part, &picture);
}

struct settings preset_settings(const struct preset *preset, const struct settings *now) {
    struct settings with;
    renderer_settings_init(&with);
    if (preset)
        settings_assign(&with, preset->settings);
    preset_keep_tone(&with, now);
    return with;
}
