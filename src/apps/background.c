#include "apps/background.h"

#include "base/error.h"
#include "base/file/image_file.h"
#include "metrics/colour.h"
#include "passes/targets.h"
#include "shared/composite.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

/* Six digits of base 16. */
static bool parse_digits(float colour[3], const char *text) {
    text += *text == '#';
    for (int i = 0; i < 6; i++)
        if (!isxdigit((unsigned char)text[i]))
            return false;
    unsigned long value = strtoul(text, NULL, 16);
    for (int c = 0; c < 3; c++)
        colour[c] = srgb_decode((float)(value >> (16 - 8 * c) & 255) / 255);
    return text[6] == '\0';
}

static bool parse_light(float colour[3], const char *text) {
    for (int c = 0; c < 3; c++) {
        char *end;
        colour[c] = strtof(text, &end);
        if (end == text || !(colour[c] >= 0 && colour[c] <= 1) || *end != (c < 2 ? ',' : '\0'))
            return false;
        text = end + 1;
    }
    return true;
}

bool background_parse(struct background *background, const char *text) {
    *background = (struct background){.kind = BACKGROUND_SCENE};
    if (!text)
        return true;
    bool none = strcmp(text, "none") == 0;
    background->kind = none ? BACKGROUND_NONE : BACKGROUND_COLOUR;
    return none || parse_digits(background->colour, text) ||
           parse_light(background->colour, text) ||
           error_set("background: '%s' is neither none, #rrggbb nor r,g,b from 0 to 1", text);
}

bool background_check(const struct background *background, const char *const *paths, int count) {
    bool shown = background->kind != BACKGROUND_COLOUR;
    for (int i = 0; i < count; i++) {
        bool is_float;
        if (!image_format_is_float(paths[i], &is_float))
            return false;
        if (background->kind == BACKGROUND_NONE && !image_format_has_alpha(paths[i]))
            return error_prefix("--background none");
        shown = shown || !is_float;
    }
    return shown || error_set("--background COLOUR is for PNG, JPEG and the like: formats of "
                              "floats hold the scene's light alone");
}
