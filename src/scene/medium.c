#include "scene/medium.h"

/* Optical depths: beyond it a picture is black or white. */
static const double depth_most = 1000;

/* Nearer to 1, light is scattered within half a degree. */
static const double g_most = .99;

static const struct option table[] = {
    {"scatter", 0, OPTION_FLOAT, offsetof(struct medium_settings, scatter), 0, 0, depth_most,
     .label = "fog that scatters",
     .help = "fog: optical depth of scattering over the scene's radius; with absorb\n"
             "it replaces the medium of the scene's file; 0: off"},
    {"absorb", 0, OPTION_FLOAT, offsetof(struct medium_settings, absorb), 0, 0, depth_most,
     .label = "fog that absorbs",
     .help = "fog: optical depth of absorption over the scene's radius; 0: off"},
    {"g", 0, OPTION_FLOAT, offsetof(struct medium_settings, g), 0, -g_most, g_most,
     .label = "forward", .needs = "medium.scatter>0",
     .help = "mean cosine of the scattering of that fog;\n"
             "above 0: forward, bright towards a light"},
    {"scene", 0, OPTION_FLAG, offsetof(struct medium_settings, scene), true,
     .label = "fog of the file", .help = "shows the medium of the scene's file, if it has one"},
    {"steps", 0, OPTION_INT, offsetof(struct medium_settings, steps), 32, 1, 1024, .label = "steps",
     .help = "shadow lookups per pixel and light along the ray through a medium;\n"
             "raise against noise in shafts of light"},
    {NULL},
};

const struct settings_part medium_part = {"medium", "participating medium", table,
                                          sizeof(struct medium_settings)};

bool medium_exists(const struct medium *medium) {
    for (int c = 0; c < 3; c++)
        if (medium->scattering[c] > 0 || medium->absorption[c] > 0)
            return true;
    return false;
}

struct medium medium_of(const struct scene *scene, const struct settings *settings, float radius) {
    const struct medium_settings *own = settings_of(struct medium_settings, settings, &medium_part);
    struct medium medium = {.g = own->g};
    if (own->scatter == 0 && own->absorb == 0)
        return own->scene ? scene->medium : (struct medium){0};
    for (int c = 0; c < 3; c++) {
        medium.scattering[c] = own->scatter / radius;
        medium.absorption[c] = own->absorb / radius;
    }
    return medium;
}
