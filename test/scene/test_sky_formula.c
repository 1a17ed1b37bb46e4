/* Skies by formula: their integrals, ratios that the standard names, symmetry, and refusals. */
#include "support.h"

#include "scene/lights/sky_formula.h"

#include <cglm/util.h>

static struct environment *make(const char *text) {
    struct environment *sky = NULL;
    check_ok(text, environment_follow(&sky, &(struct environment_desc){.path = text}));
    return sky;
}

/* azimuth from -Z towards +X and elevation, degrees. */
static void color_at(const struct environment *sky, double azimuth, double elevation,
                     float rgb[3]) {
    double a = azimuth * GLM_PI / 180, e = elevation * GLM_PI / 180;
    const float direction[3] = {(float)(sin(a) * cos(e)), (float)sin(e), (float)(-cos(a) * cos(e))};
    environment_radiance(sky, direction, rgb);
}

static double at(const struct environment *sky, double azimuth, double elevation) {
    float rgb[3];
    color_at(sky, azimuth, elevation, rgb);
    return (double)rgb[1];
}

/* Directions of even density by the cosine see the wanted irradiance of a level plane. */
TEST(integral) {
    enum { SAMPLES = 20000 };
    for (int type = 1; type <= 16; type++) {
        double sum = 0;
        const char *text = form("cie:%d,horizontal=10000,elevation=35", type);
        struct environment *sky = make(text);
        for (int i = 0; i < SAMPLES; i++) {
            double elevation = asin(sqrt((i + .5) / SAMPLES)) * 180 / GLM_PI;
            sum += GLM_PI / SAMPLES * at(sky, 137.50776 * i, elevation);
        }
        check_near(text, sum, 10000, 30);
        check_near("ground", at(sky, 0, -20), 0, 0);
        environment_free(sky);
    }
}

TEST(ratios) {
    struct environment *even = make("cie:5,zenith=7");
    for (int i = 0; i < 100; i++)
        check_near("even", at(even, 31 * i, .5 + .89 * i), 7, 1e-5);
    environment_free(even);
    struct environment *overcast = make("cie:1,zenith=300");
    check_near("zenith over horizon", at(overcast, 10, 89.9) / at(overcast, 10, .4),
               1 + 4 * exp(-.7), .02);
    environment_free(overcast);
    struct environment *traditional = make("cie:16");
    check_near("traditional", at(traditional, 10, 89.9) / at(traditional, 10, .1), 3, .05);
    check_near("its zenith", at(traditional, 10, 89.9), 9. / 7, .01); /* E = 7/9 pi L */
    environment_free(traditional);
}

/* ISO 15469 for a clear sky, written once more; brightest where the sun is, alike on both sides. */
TEST(clear) {
    static const double sun_azimuth = 90, sun_elevation = 30;
    struct environment *sky = make("cie:12,azimuth=90,elevation=30,zenith=1");
    double worst = 0, uneven = 0, most = 0, where[2] = {0};
    for (int i = 0; i < 4000; i++) {
        double azimuth = fmod(137.50776 * i, 360), elevation = 2 + 86. * i / 4000;
        double z = (90 - elevation) * GLM_PI / 180, zs = (90 - sun_elevation) * GLM_PI / 180;
        double apart =
            acos(cos(zs) * cos(z) + sin(zs) * sin(z) * cos((azimuth - sun_azimuth) * GLM_PI / 180));
        double f = 1 + 10 * (exp(-3 * apart) - exp(-3 * GLM_PI / 2)) + .45 * pow(cos(apart), 2);
        double f0 = 1 + 10 * (exp(-3 * zs) - exp(-3 * GLM_PI / 2)) + .45 * pow(cos(zs), 2);
        double expected = (1 - exp(-.32 / cos(z))) * f / ((1 - exp(-.32)) * f0);
        double value = at(sky, azimuth, elevation);
        worst = fmax(worst, fabs(value / expected - 1));
        uneven = fmax(uneven, fabs(at(sky, 180 - azimuth, elevation) / value - 1));
        if (value > most) {
            most = value;
            where[0] = azimuth;
            where[1] = elevation;
        }
    }
    check_at_most("of the formula, within a texel", worst, .04);
    check_at_most("between both sides", uneven, .04);
    check_near("azimuth of the brightest", where[0], sun_azimuth, 5);
    check_near("elevation of the brightest", where[1], sun_elevation, 5);
    environment_free(sky);
}

/* Luminance, x and y of BT.709's colours. */
static void luminance_at(const struct environment *sky, double azimuth, double elevation,
                         double xyy[3]) {
    float rgb[3];
    color_at(sky, azimuth, elevation, rgb);
    double r = (double)rgb[0], g = (double)rgb[1], b = (double)rgb[2];
    double x = .4124 * r + .3576 * g + .1805 * b, z = .0193 * r + .1192 * g + .9505 * b;
    xyy[0] = .2126 * r + .7152 * g + .0722 * b;
    xyy[1] = x / (x + xyy[0] + z);
    xyy[2] = xyy[0] / (x + xyy[0] + z);
}

/* The zenith of turbidity 2 and a sun at 45 degrees, and of 6 and 70, by a pocket calculator from
 * the paper's formulas; then its luminance elsewhere over that of the zenith. */
TEST(preetham) {
    static const struct {
        const char *text;
        double zenith[3], a, b, c, d, e;
    } skies[] = {
        {"preetham:2,elevation=45,azimuth=90",
         {4.4696, .24095, .24372},
         -1.1056,
         -.2833,
         5.2797,
         -2.3359,
         .2363},
        {"preetham:6,elevation=70,azimuth=90",
         {28.919, .26728, .28018},
         -.3908,
         -1.7049,
         5.1889,
         -1.8535,
         -.0317},
    };
    for (size_t i = 0; i < sizeof skies / sizeof *skies; i++) {
        struct environment *sky = make(skies[i].text);
        double found[3], zenith[3], zs = (i ? 20 : 45) * GLM_PI / 180;
        luminance_at(sky, 10, 89.7, zenith);
        check_near("luminance", zenith[0] / skies[i].zenith[0], 1, .01);
        check_near("x", zenith[1], skies[i].zenith[1], .0005);
        check_near("y", zenith[2], skies[i].zenith[2], .0005);
        for (int k = 0; k < 6; k++) {
            double z = (10 + 14 * k) * GLM_PI / 180, turn = 63. * k;
            double apart = acos(cos(zs) * cos(z) + sin(zs) * sin(z) * cos(turn * GLM_PI / 180));
            luminance_at(sky, 90 + turn, 90 - z * 180 / GLM_PI, found);
            check_near(
                "over the zenith's",
                found[0] / zenith[0] * (1 + skies[i].a * exp(skies[i].b)) *
                    (1 + skies[i].c * exp(skies[i].d * zs) + skies[i].e * pow(cos(zs), 2)) /
                    ((1 + skies[i].a * exp(skies[i].b / cos(z))) *
                     (1 + skies[i].c * exp(skies[i].d * apart) + skies[i].e * pow(cos(apart), 2))),
                1, .04);
        }
        environment_free(sky);
    }
}

TEST(refusals) {
    static const char *const texts[][2] = {
        {"cie:", "cie:: type: '' is not a whole number from 1 to 16"},
        {"cie:0", "'0' is not a whole number from 1 to 16"},
        {"cie:17", "'17' is not a whole number from 1 to 16"},
        {"cie:five", "'five' is not a whole number"},
        {"cie:5,sun=3", "'sun=3': it wants TYPE,azimuth="},
        {"cie:5,7", "'7': it wants TYPE,azimuth="},
        {"cie:5,elevation=-3", "'-3' is not a number from 0 to 90"},
        {"cie:5,zenith=nan", "'nan' is not a number"},
        {"cie:5,zenith=", "zenith"},
        {"preetham:1", "turbidity: '1' is not a number from 2 to 10"},
        {"preetham:3,type=2", "'type=2': it wants TURBIDITY,azimuth="},
        {"cie:5,zenith=1,horizontal=1", "zenith and horizontal exclude each other"},
    };
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        struct environment sky;
        check_refused(environment_load(&sky, texts[i][0]), texts[i][1]);
    }
}

RUN_TESTS(NULL, NULL)
