#include "scene/lights/sky_formula.h"

#include "base/error.h"
#include "base/memory.h"
#include "base/option.h"
#include "base/primaries.h"
#include "base/words.h"

#include <cglm/mat3.h>
#include <cglm/util.h>
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

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

/* Slope by turbidity and constant of a to e, for luminance and chromaticity x and y; and the
 * zenith's chromaticity by cubes of the sun's zenith angle [Preetham et al. 1999, A.2]. */
static const double slopes[3][5][2] = {
    {{.1787, -1.463}, {-.3554, .4275}, {-.0227, 5.3251}, {.1206, -2.5771}, {-.067, .3703}},
    {{-.0193, -.2592}, {-.0665, .0008}, {-.0004, .2125}, {-.0641, -.8989}, {-.0033, .0452}},
    {{-.0167, -.2608}, {-.095, .0092}, {-.0079, .2102}, {-.0441, -1.6537}, {-.0109, .0529}},
};
static const double zeniths[2][3][4] = {
    {{.00166, -.00375, .00209, 0},
     {-.02903, .06377, -.03202, .00394},
     {.11693, -.21196, .06052, .25886}},
    {{.00275, -.0061, .00317, 0},
     {-.04214, .0897, -.04153, .00516},
     {.15346, -.26756, .0667, .26688}},
};

struct values {
    int type;
    float turbidity, azimuth, elevation, zenith, horizontal;
};

static const struct option words[] = {
    {"azimuth", 0, OPTION_FLOAT, offsetof(struct values, azimuth), 180, -360, 360, .help = ""},
    {"elevation", 0, OPTION_FLOAT, offsetof(struct values, elevation), 45, 0, 90, .help = ""},
    {"zenith", 0, OPTION_FLOAT, offsetof(struct values, zenith), 0, 1e-6, 1e9, .help = ""},
    {"horizontal", 0, OPTION_FLOAT, offsetof(struct values, horizontal), 0, 1e-6, 1e9, .help = ""},
    {NULL},
};

/* The first word has a value and no name. */
static const struct model {
    const char *prefix;
    struct option first;
} cie = {"cie:",
         {"type", 0, OPTION_INT, offsetof(struct values, type), 5, 1, TRADITIONAL,
          .value_name = "TYPE"}},
  preetham = {"preetham:",
              {"turbidity", 0, OPTION_FLOAT, offsetof(struct values, turbidity), 3, 2, 10,
               .value_name = "TURBIDITY"}};

static bool begins(const char *text, const struct model *model) {
    return strncmp(text, model->prefix, strlen(model->prefix)) == 0;
}

bool sky_formula_is(const char *text) {
    return begins(text, &cie) || begins(text, &preetham);
}

static bool parse_word(const struct model *model, const struct word *word, struct values *values) {
    char key[64], value[64];
    const char *equals = memchr(word->at, '=', (size_t)word->length);
    int length = equals ? (int)(equals - word->at) : word->length;
    snprintf(key, sizeof key, "%.*s", length, word->at);
    bool is_first = strcmp(key, model->first.name) == 0;
    const struct option *option = is_first ? &model->first : option_find(words, key);
    if (!equals || !option)
        return error_set("'%.*s': it wants %s,azimuth=,elevation=,zenith=,horizontal=",
                         word->length, word->at, model->first.value_name);
    snprintf(value, sizeof value, "%.*s", word->length - length - 1, equals + 1);
    return option_parse(option, values, value);
}

static bool parse(const char *text, struct values *values) {
    const struct model *model = begins(text, &cie) ? &cie : &preetham;
    char *all = mem_printf("%s=%s", model->first.name, text + strlen(model->prefix));
    bool ok = true;
    options_set_defaults(words, values);
    for (struct word word = {.at = all}; ok && word_next(&word);)
        ok = parse_word(model, &word, values);
    free(all);
    return ok && (values->zenith == 0 || values->horizontal == 0 ||
                  error_set("zenith and horizontal exclude each other"));
}

/* One value by direction: a gradation by the cosine of the zenith angle times an indicatrix by the
 * cosine of the angle to the sun. `less` makes the indicatrix 1 beside the sun. */
struct part {
    double t[5], less;
    bool is_traditional;
};

static double part_at(const struct part *part, double cosine, double to_sun) {
    const double *t = part->t, angle = acos(fmin(fmax(to_sun, -1), 1));
    double gradation = part->is_traditional ? (1 + 2 * cosine) / 3 : 1 + t[0] * exp(t[1] / cosine);
    return gradation * (1 + t[2] * (exp(t[3] * angle) - part->less) + t[4] * to_sun * to_sun);
}

/* Luminance and chromaticity x and y; white for a CIE sky. */
struct sky {
    double sun[3], zenith[3];
    struct part parts[3];
    mat3 xyz_to_rgb;
};

static void set_cie(struct sky *sky, int type) {
    const double *t = types[type - 1];
    sky->zenith[0] = 1;
    sky->zenith[1] = sky->zenith[2] = 1. / 3;
    glm_mat3_identity(sky->xyz_to_rgb);
    sky->parts[0] =
        (struct part){{t[0], t[1], t[2], t[3], t[4]}, exp(t[3] * GLM_PI_2), type == TRADITIONAL};
}

/* The zenith's luminance in kcd/m2, then its chromaticity. */
static void set_preetham(struct sky *sky, double turbidity) {
    double z = acos(sky->sun[1]), chi = (4. / 9 - turbidity / 120) * (GLM_PI - 2 * z);
    primaries_matrix_of_xyz(sky->xyz_to_rgb);
    sky->zenith[0] = (4.0453 * turbidity - 4.971) * tan(chi) - .2155 * turbidity + 2.4192;
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 12; k++)
            sky->zenith[1 + i] +=
                zeniths[i][k / 4][k % 4] * pow(turbidity, 2 - k / 4) * pow(z, 3 - k % 4);
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 5; k++)
            sky->parts[i].t[k] = slopes[i][k][0] * turbidity + slopes[i][k][1];
}

/* Returns the luminance. */
static double radiance(const struct sky *sky, const float d[3], float rgb[3]) {
    double v[3];
    for (int i = 0; i < 3; i++)
        v[i] = sky->zenith[i] *
               part_at(&sky->parts[i], (double)d[1],
                       sky->sun[0] * (double)d[0] + sky->sun[1] * (double)d[1] +
                           sky->sun[2] * (double)d[2]) /
               part_at(&sky->parts[i], 1, sky->sun[1]);
    double sum = v[0] / v[2];
    glm_mat3_mulv((vec3 *)sky->xyz_to_rgb,
                  (vec3){(float)(v[1] * sum), (float)v[0], (float)((1 - v[1] - v[2]) * sum)}, rgb);
    glm_vec3_clamp(rgb, 0, FLT_MAX);
    return v[0];
}

/* Returns the illuminance of a level plane, of the texels as they are. */
static double fill(struct environment *environment, const struct sky *sky) {
    double sum = 0;
    for (int y = 0; y < environment->height / 2; y++) {
        double sine = sin(GLM_PI * y / environment->height),
               next = sin(GLM_PI * (y + 1) / environment->height);
        double weight = GLM_PI / environment->width * (next * next - sine * sine);
        for (int x = 0; x < environment->width; x++) {
            float direction[3];
            environment_direction(environment, x + .5, y + .5, direction);
            sum +=
                weight * radiance(sky, direction, environment->texels[y * environment->width + x]);
        }
    }
    return sum;
}

bool sky_formula_make(struct environment *environment, const char *text) {
    struct values values = {0};
    *environment = (struct environment){.width = 2 * HEIGHT, .height = HEIGHT, .strength = 1};
    if (!parse(text, &values))
        return error_prefix("%s", text);
    double azimuth = (double)values.azimuth * GLM_PI / 180;
    double elevation = (double)values.elevation * GLM_PI / 180;
    struct sky sky = {
        .sun = {sin(azimuth) * cos(elevation), sin(elevation), -cos(azimuth) * cos(elevation)}};
    if (values.type)
        set_cie(&sky, values.type);
    else
        set_preetham(&sky, (double)values.turbidity);
    environment->texels = mem_alloc((size_t)2 * HEIGHT * HEIGHT, sizeof *environment->texels);
    double level = fill(environment, &sky), scale = values.type ? GLM_PI / level : 1;
    if (values.horizontal > 0)
        scale = (double)values.horizontal / level;
    if (values.zenith > 0)
        scale = (double)values.zenith / sky.zenith[0];
    for (int i = 0; i < HEIGHT * HEIGHT; i++)
        for (int c = 0; c < 3; c++)
            environment->texels[i][c] *= (float)scale;
    return true;
}
