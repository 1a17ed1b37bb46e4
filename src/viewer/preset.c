#include "viewer/preset.h"

#include <string.h>

const char *preset_title(const struct preset *preset) {
    static const char *const titles[][2] = {{"draft", "Draft"},
                                            {"fast", "Normal"},
                                            {"fine", "High"},
                                            {"traced", "Traced"},
                                            {"paper", "Published"}};
    for (size_t i = 0; i < sizeof titles / sizeof *titles; i++)
        if (strcmp(preset->name, titles[i][0]) == 0)
            return titles[i][1];
    return preset->name;
}

void preset_keep_tone(struct settings *settings, const struct settings *now) {
    const struct picture_settings *shown = settings_of(now, &picture_part);
    struct picture_settings *picture = settings_edit(settings, &picture_part);
    picture->exposure = shown->exposure;
    picture->tone_map = shown->tone_map;
}

struct settings preset_settings(const struct preset *preset, const struct settings *now) {
    struct settings with;
    renderer_settings_init(&with);
    if (preset)
        settings_assign(&with, preset->settings);
    preset_keep_tone(&with, now);
    return with;
}
