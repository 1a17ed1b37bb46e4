/* A small frame of each technique and each direct method beside stored means of its four quarters: what the closed forms
 * of other programs do not see, in seconds. A row is printed as it is written here, so that a change that is meant to
 * change pictures renews it. */
#include "render_support.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define SMALL                                                                                      \
    "vpls=256,map-size=128,shadow-size=512,rsm-size=128,map-points=1024,row-column.rows=36,"       \
    "row-column.columns=64"

enum { QUARTERS = 4, VALUES = 3 * QUARTERS, SIZE = 48 };

/* Over the largest value: drivers round otherwise. Techniques differ by .01. */
static const double TOLERANCE = .004;

struct row {
    const char *name;
    double values[VALUES]; /* red, green, blue of the quarters, from the top left along rows */
};

static const struct row techniques_of_box[] = {
    {"cluster-lights",
     {0.6226, 0.3331, 0.3131, 0.2585, 0.09641, 0.08901, 0.2304, 0.1672, 0.159, 0.1602, 0.0971,
      0.0918}},
    {"clustered",
     {0.621, 0.3318, 0.3119, 0.2595, 0.09655, 0.08914, 0.2332, 0.169, 0.1607, 0.1629, 0.09821,
      0.09285}},
    {"imperfect-shadow-maps",
     {0.6186, 0.3303, 0.3105, 0.2568, 0.09629, 0.08895, 0.2314, 0.1682, 0.16, 0.1581, 0.09562,
      0.09041}},
    {"imperfect-volume",
     {0.6284, 0.3383, 0.3168, 0.2684, 0.1016, 0.09348, 0.2357, 0.1681, 0.1591, 0.1568, 0.09516,
      0.08956}},
    {"implicit-visibility",
     {0.6273, 0.3308, 0.3107, 0.2618, 0.09801, 0.09046, 0.2292, 0.162, 0.1539, 0.1603, 0.09698,
      0.09165}},
    {"instant-radiosity",
     {0.6214, 0.3321, 0.3122, 0.2595, 0.09655, 0.08914, 0.2347, 0.1703, 0.162, 0.1653, 0.1003,
      0.09482}},
    {"lightcuts",
     {0.6206, 0.3311, 0.3112, 0.2586, 0.09624, 0.08884, 0.2315, 0.1679, 0.1597, 0.1619, 0.09797,
      0.09262}},
    {"row-column",
     {0.6185, 0.3266, 0.3068, 0.2607, 0.09954, 0.09202, 0.2313, 0.1688, 0.1606, 0.1597, 0.09997,
      0.09464}},
    {"unshadowed",
     {0.622, 0.3322, 0.3123, 0.2665, 0.09732, 0.08975, 0.2431, 0.1779, 0.1692, 0.2345, 0.1264,
      0.119}},
    {NULL, {0}},
};

static const struct row methods_of_table[] = {
    {"hard",
     {0.1322, 0.1256, 0.1123, 0.1782, 0.1693, 0.1515, 0.1446, 0.1373, 0.1229, 0.1171, 0.1113,
      0.09957}},
    {"pcss",
     {0.1322, 0.1256, 0.1124, 0.1779, 0.169, 0.1512, 0.1429, 0.1357, 0.1215, 0.1192, 0.1133,
      0.1013}},
    {"samples",
     {0.1321, 0.1255, 0.1123, 0.1782, 0.1693, 0.1515, 0.1459, 0.1386, 0.124, 0.1212, 0.1152,
      0.103}},
    {"vssm",
     {0.1322, 0.1256, 0.1124, 0.1786, 0.1697, 0.1518, 0.1436, 0.1364, 0.122, 0.1182, 0.1123,
      0.1005}},
    {"msm",
     {0.1322, 0.1256, 0.1124, 0.1786, 0.1696, 0.1518, 0.1434, 0.1362, 0.1219, 0.1175, 0.1116,
      0.09984}},
    {"cssm",
     {0.1322, 0.1256, 0.1124, 0.1783, 0.1694, 0.1516, 0.1468, 0.1394, 0.1247, 0.1192, 0.1132,
      0.1013}},
    {NULL, {0}},
};

static void quarter_means(const struct image *image, const char *layer, double values[VALUES]) {
    int channels[3];
    assert_true(image_find_layer(image, layer, channels));
    memset(values, 0, VALUES * sizeof *values);
    for (int y = 0; y < SIZE; y++)
        for (int x = 0; x < SIZE; x++)
            for (int c = 0; c < 3; c++)
                values[3 * (2 * (2 * y / SIZE) + 2 * x / SIZE) + c] +=
                    (double)image_at(image, x, y)[channels[c]] * QUARTERS / (SIZE * SIZE);
}

/* The largest difference over the largest value; prints the row. */
static double error_of(const char *name, const struct image *image, const char *layer,
                       const struct row *rows) {
    double values[VALUES], largest = 0, error = INFINITY;
    quarter_means(image, layer, values);
    printf("    {\"%s\", {", name);
    for (int i = 0; i < VALUES; i++) {
        printf("%s%.4g", i ? ", " : "", values[i]);
        largest = fmax(largest, values[i]);
    }
    while (rows->name && strcmp(rows->name, name) != 0)
        rows++;
    for (int i = 0; rows->name && i < VALUES; i++)
        error = fmax(i ? error : 0, fabs(values[i] - rows->values[i]) / largest);
    printf("}}, off by %.4f\n", error);
    return error;
}

static void test_techniques(void **state) {
    (void)state;
    struct stage stage;
    double worst = 0;
    open_stage(&stage, "scenes/cornell-box.glb");
    for (const struct technique *const *t = techniques; *t; t++) {
        struct image layers = render_stage(&stage, (*t)->name, SMALL, SIZE);
        worst = fmax(worst, error_of((*t)->name, &layers, "indirect", techniques_of_box));
        image_free(&layers);
    }
    check_at_most("worst", worst, TOLERANCE);
    stage_free(&stage);
}

static void test_direct(void **state) {
    (void)state;
    struct stage stage;
    double worst = 0;
    open_stage(&stage, "scenes/table.glb");
    for (const struct direct_method *const *method = direct_methods; *method; method++) {
        struct renderer_desc desc = desc_of(&stage, "unshadowed", SMALL, SIZE, SIZE);
        desc.direct = *method;
        struct image layers = render_layers(&desc);
        worst = fmax(worst, error_of((*method)->name, &layers, "direct", methods_of_table));
        image_free(&layers);
    }
    check_at_most("worst", worst, TOLERANCE);
    stage_free(&stage);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_techniques),
                                       cmocka_unit_test(test_direct)};
    return cmocka_run_group_tests_name("frames", tests, open_group_context, close_group_context);
}
