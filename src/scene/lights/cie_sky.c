#include "scene/lights/cie_sky.h"

#include "base/error.h"
#include "base/memory.h"
#include "base/option.h"
#include "base/words.h"

#include <cglm/util.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char prefix[] = "cie:";

enum { HEIGHT = 256, TRADITIONAL = 16 };

/* Gradation a, b from zenith to horizon; indicatrix c, d, e around the sun [ISO 15469, table 1]. */
static const double types[][5] = {
    {4, -.7, 0, -1, 0},       {4, -.7, 2, -1.5, .15},  {1.1, -.8, 0, -1, 0},
    {1.1, -.8, 2, -1.5, .15}, {0, -1, 0, -1, 0},       {0, -1, 2, -1.5, .15},
    {0, -1, 5, -2.5, .3},     {0, -1, 10, -3, .45},    {-1, -.55, 2, -1.5, .15},
    {-1, -.55, 5, -2.5, .3},  {-1, -.55, 10, -3, .45}, {-1, -.32, 10, -3, .45},
    {-1, -.32, 16, -3, .3},   {-1, -.15, 16, -3, .3},  {-1, -.15, 24, -2.8, .15},
    {0, -1, 0, -1, 0}, /* TRADITIONAL */
};

struct values {
    int type;
    float azimuth, elevation, zenith, horizontal;
};

static const struct option words[] = {
    {"type", 0, OPTION_INT, offsetof(struct values, type), 5, 1, TRADITIONAL, .help = ""},
    {"azimuth", 0, OPTION_FLOAT, offsetof(struct values, azimuth), 180, -360, 360, .help = ""},
    {"elevation", 0, OPTION_FLOAT, offsetof(struct values, elevation), 45, 0, 90, .help = ""},
    {"zenith", 0, OPTION_FLOAT, offsetof(struct values, zenith), 0, 1e-6, 1e9, .help = ""},
    {"horizontal", 0, OPTION_FLOAT, offsetof(struct values, horizontal), 0, 1e-6, 1e9, .help = ""},
    {NULL},
};

bool cie_sky_is(const char *text) {
    return strncmp(text, prefix, sizeof prefix - 1) == 0;
}

static bool parse_word(const struct word *word, struct values *values) {
    char key[64], value[64];
    const char *equals = memchr(word->at, '=', (size_t)word->length);
    int length = equals ? (int)(equals - word->at) : word->length;
    snprintf(key, sizeof key, "%.*s", length, word->at);
    const struct option *option = option_find(words, key);
    if (!equals || !option)
        return error_set("'%.*s': it wants TYPE,azimuth=,elevation=,zenith=,horizontal=",
                         word->length, word->at);
    snprintf(value, sizeof value, "%.*s", word->length - length - 1, equals + 1);
    return option_parse(option, values, value);
}

static bool parse(const char *text, struct values *values) {
    char *all = mem_printf("type=%s", text + sizeof prefix - 1);
    bool ok = true;
    options_set_defaults(words, values);
    for (struct word word = {.at = all}; ok && word_next(&word);)
        ok = parse_word(&word, values);
    free(all);
    return ok && (values->zenith == 0 || values->horizontal == 0 ||
                  error_set("zenith and horizontal exclude each other"));
}

static double gradation(const struct values *values, double cosine) {
    const double *t = types[values->type - 1];
    return values->type == TRADITIONAL ? (1 + 2 * cosine) / 3 : 1 + t[0] * exp(t[1] / cosine);
}

static double indicatrix(const struct values *values, double cosine) {
    const double *t = types[values->type - 1];
    double angle = acos(fmin(fmax(cosine, -1), 1));
    return 1 + t[2] * (exp(t[3] * angle) - exp(t[3] * GLM_PI_2)) + t[4] * cosine * cosine;
}

/* Over the zenith's radiance. */
static double radiance(const struct values *values, const double sun[3], const float d[3]) {
    double to_sun = sun[0] * (double)d[0] + sun[1] * (double)d[1] + sun[2] * (double)d[2];
    return gradation(values, (double)d[1]) * indicatrix(values, to_sun) /
           (gradation(values, 1) * indicatrix(values, sun[1]));
}

/* Returns the irradiance of a level plane, of the texels as they are. */
static double fill(struct environment *environment, const struct values *values,
                   const double sun[3]) {
    double sum = 0;
    for (int y = 0; y < environment->height / 2; y++) {
        double sine = sin(GLM_PI * y / environment->height),
               next = sin(GLM_PI * (y + 1) / environment->height);
        double weight = GLM_PI / environment->width * (next * next - sine * sine);
        for (int x = 0; x < environment->width; x++) {
            float direction[3];
            environment_direction(environment, x + .5, y + .5, direction);
            double value = radiance(values, sun, direction);
            sum += weight * value;
            for (int c = 0; c < 3; c++)
                environment->texels[y * environment->width + x][c] = (float)value;
        }
    }
    return sum;
}

bool cie_sky_make(struct environment *environment, const char *text) {
    struct values values;
    *environment = (struct environment){.width = 2 * HEIGHT, .height = HEIGHT, .strength = 1};
    if (!parse(text, &values))
        return error_prefix("%s", text);
    double azimuth = (double)values.azimuth * GLM_PI / 180;
    double elevation = (double)values.elevation * GLM_PI / 180;
    const double sun[3] = {sin(azimuth) * cos(elevation), sin(elevation),
                           -cos(azimuth) * cos(elevation)};
    environment->texels = mem_alloc((size_t)2 * HEIGHT * HEIGHT, sizeof *environment->texels);
    double wanted = values.horizontal > 0 ? (double)values.horizontal : GLM_PI;
    double scale = wanted / fill(environment, &values, sun);
    if (values.zenith > 0)
        scale = (double)values.zenith;
    for (int i = 0; i < HEIGHT * HEIGHT; i++)
        for (int c = 0; c < 3; c++)
            environment->texels[i][c] *= (float)scale;
    return true;
}
