/* A small frame of each technique and each direct method beside stored means of its quarters: what
 * the closed forms of other programs do not see, in seconds. The rows are printed as they are
 * written here: a change that is meant to change pictures renews them. */
#include "render_support.h"

#define SMALL                                                                                      \
    "vpls=256,map-size=128,shadow-size=512,rsm-size=128,map-points=1024,row-column.rows=36,"       \
    "row-column.columns=64"

enum { QUARTERS = 4, SIZE = 48 };

/* Over the largest mean: drivers round otherwise. Techniques differ by .01. */
static const double TOLERANCE = .004;

/* Red + 2 green + 4 blue, from the top left along rows. */
struct row {
    const char *name;
    double means[QUARTERS];
};

static const struct row techniques_of_box[] = {
    {"cluster-lights", {2.541, 0.8074, 1.201, 0.7216}},
    {"clustered", {2.532, 0.8092, 1.214, 0.7307}},
    {"imperfect-shadow-maps", {2.521, 0.8051, 1.208, 0.7109}},
    {"imperfect-volume", {2.572, 0.8455, 1.208, 0.7054}},
    {"implicit-visibility", {2.532, 0.8196, 1.169, 0.7209}},
    {"instant-radiosity", {2.535, 0.8092, 1.223, 0.7451}},
    {"lightcuts", {2.528, 0.8065, 1.206, 0.7283}},
    {"row-column", {2.499, 0.8279, 1.211, 0.7382}},
    {"unshadowed", {2.536, 0.8202, 1.276, 0.9632}},
    {NULL, {0}},
};

static const struct row methods_of_table[] = {
    {"hard", {0.8327, 1.123, 0.9107, 0.738}},
    {"pcss", {0.8327, 1.121, 0.9002, 0.7511}},
    {"samples", {0.8322, 1.123, 0.9189, 0.7637}},
    {"vssm", {0.8327, 1.125, 0.9045, 0.7446}},
    {"msm", {0.8327, 1.125, 0.9035, 0.74}},
    {"cssm", {0.8327, 1.123, 0.9245, 0.7508}},
    {NULL, {0}},
};

/* The largest difference over the largest mean. */
static double error_of(const char *name, const struct image *image, const char *layer,
                       const struct row *rows) {
    double means[QUARTERS] = {0}, largest = 0, error = INFINITY;
    int channels[3];
    assert_true(image_find_layer(image, layer, channels));
    for (int y = 0; y < SIZE; y++)
        for (int x = 0; x < SIZE; x++)
            for (int c = 0; c < 3; c++)
                means[2 * (2 * y / SIZE) + 2 * x / SIZE] +=
                    (1 << c) * (double)image_at(image, x, y)[channels[c]] * 4 / (SIZE * SIZE);
    while (rows->name && strcmp(rows->name, name) != 0)
        rows++;
    for (int i = 0; i < QUARTERS; i++)
        largest = fmax(largest, means[i]);
    for (int i = 0; rows->name && i < QUARTERS; i++)
        error = fmax(i ? error : 0, fabs(means[i] - rows->means[i]) / largest);
    printf("    {\"%s\", {%.4g, %.4g, %.4g, %.4g}}, off by %.4f\n", name, means[0], means[1],
           means[2], means[3], error);
    return error;
}

TEST(techniques) {
    double worst = 0;
    OWNED(stage) stage = open_stage("scenes/cornell-box.glb");
    for (const struct technique *const *t = techniques; *t; t++) {
        OWNED(image) layers = render_stage(&stage, (*t)->name, SMALL, SIZE);
        worst = fmax(worst, error_of((*t)->name, &layers, "indirect", techniques_of_box));
    }
    check_at_most("worst", worst, TOLERANCE);
}

TEST(direct) {
    double worst = 0;
    OWNED(stage) stage = open_stage("scenes/table.glb");
    struct renderer_desc desc = desc_of(&stage, "unshadowed", SMALL, SIZE, SIZE);
    for (const struct direct_method *const *method = direct_methods; *method; method++) {
        desc.direct = *method;
        OWNED(image) layers = render_layers(&desc);
        worst = fmax(worst, error_of((*method)->name, &layers, "direct", methods_of_table));
    }
    check_at_most("worst", worst, TOLERANCE);
}

RUN_TESTS(open_group_context, close_group_context)
