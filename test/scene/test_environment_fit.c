/* An environment as area lights: nothing is lost, an even sky is one, the sun comes first. */
#include "base/unit.h"
#include "support.h"

#include "lights/environment_fit.h"

enum { WIDTH = 128, HEIGHT = 64 };

static struct environment make_sky(void (*paint)(const float direction[3], float radiance[3])) {
    struct environment sky = {.width = WIDTH, .height = HEIGHT, .strength = 1};
    sky.texels = mem_alloc(WIDTH * HEIGHT, sizeof *sky.texels);
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        float direction[3];
        environment_direction(&sky, i % WIDTH + .5, i / WIDTH + .5, direction);
        paint(direction, sky.texels[i]);
    }
    return sky;
}

static const float sun[3] = {.48F, .64F, .6F};

static void paint_even(const float direction[3], float radiance[3]) {
    (void)direction;
    glm_vec3_copy((vec3){.3F, .2F, .1F}, radiance);
}

/* Blue above, brown below, brighter at the horizon. */
static void paint_day(const float direction[3], float radiance[3]) {
    float up = direction[1], haze = expf(-4 * fabsf(up));
    glm_vec3_copy(up > 0 ? (vec3){.2F + haze, .4F + haze, 1 + haze} : (vec3){.2F, .15F, .1F},
                  radiance);
    radiance[0] += .05F * (direction[0] + 2) * (direction[2] + 3); /* no two sides are alike */
}

static void paint_sunny(const float direction[3], float radiance[3]) {
    paint_day(direction, radiance);
    if (glm_vec3_dot((float *)direction, (float *)sun) > .9985F)
        glm_vec3_copy((vec3){3000, 2800, 2500}, radiance);
}

static void paint_black(const float direction[3], float radiance[3]) {
    bool lit = direction[1] > .9F;
    glm_vec3_broadcast(lit ? 2 : 0, radiance);
}

static struct {
    const char *name;
    void (*paint)(const float direction[3], float radiance[3]);
} const skies[] = {
    {"even", paint_even}, {"day", paint_day}, {"sunny", paint_sunny}, {"lit above", paint_black}};

static void add_energy(const struct environment_light *lights, int count, double energy[3]) {
    for (int i = 0; i < count; i++)
        for (int c = 0; c < 3; c++)
            energy[c] += (double)(lights[i].radiance[c] * lights[i].solid_angle);
}

enum { FITS = 2 };
static const char *const fits[FITS] = {"rectangles", "even parts"};

TEST(conservation) {
    for (size_t s = 0; s < sizeof skies / sizeof *skies; s++)
        for (int fit = 0; fit < FITS; fit++)
            for (int wanted = ENVIRONMENT_LIGHTS_MIN; wanted < 100; wanted = 5 * wanted) {
                struct environment_light lights[ENVIRONMENT_LIGHTS_MAX];
                struct environment sky = make_sky(skies[s].paint);
                int count = environment_fit(lights, &sky, (enum sky_fit)fit, wanted);
                double got[3] = {0}, expected[3] = {0};
                printf("  %s, %s: %d lights of %d\n", skies[s].name, fits[fit], count, wanted);
                assert_true(count >= 1 && count <= wanted);
                if (wanted > 6 && s < 3)
                    assert_true(count > .6 * wanted);
                add_energy(lights, count, got);
                for (int i = 0; i < WIDTH * HEIGHT; i++)
                    for (int c = 0; c < 3; c++)
                        expected[c] +=
                            environment_solid_angle(&sky, i / WIDTH) * (double)sky.texels[i][c];
                for (int c = 0; c < 3; c++)
                    check_near("energy", got[c], expected[c], 1e-4 * expected[c]);
                free(sky.texels);
            }
}

/* Lambert's sum over a light above the horizon, or cut off by it. */
static double lambert(const struct environment_light *light, const float normal[3]) {
    vec3 corners[8];
    int count = 0;
    for (int i = 0; i < 4; i++) {
        const float *a = light->corners[i], *b = light->corners[(i + 1) % 4];
        float above_a = glm_vec3_dot((float *)a, (float *)normal);
        float above_b = glm_vec3_dot((float *)b, (float *)normal);
        if (above_a >= 0)
            glm_vec3_copy((float *)a, corners[count++]);
        if ((above_a < 0) != (above_b < 0)) {
            glm_vec3_lerp((float *)a, (float *)b, above_a / (above_a - above_b), corners[count]);
            vec3_unit(corners[count++]);
        }
    }
    double sum = 0;
    for (int i = 0; i < count; i++) {
        vec3 across;
        float *a = corners[i], *b = corners[(i + 1) % count];
        glm_vec3_cross(a, b, across);
        double sine = (double)glm_vec3_norm(across);
        if (sine > 0)
            sum += .5 * atan2(sine, (double)glm_vec3_dot(a, b)) *
                   (double)glm_vec3_dot(across, (float *)normal) / sine;
    }
    return sum;
}

/* pi L, whichever way a surface faces and however many lights there are: they part the sphere. */
TEST(even_sky) {
    static const float normals[4][3] = {
        {0, 1, 0}, {.6F, .8F, 0}, {-.36F, .48F, -.8F}, {0, -.6F, .8F}};
    struct environment sky = make_sky(paint_even);
    for (int fit = 0; fit < FITS; fit++)
        for (int wanted = 6; wanted <= 96; wanted *= 2) {
            struct environment_light lights[ENVIRONMENT_LIGHTS_MAX];
            int count = environment_fit(lights, &sky, (enum sky_fit)fit, wanted);
            double angle = 0;
            for (int i = 0; i < count; i++)
                angle += (double)lights[i].solid_angle;
            printf("  %d lights\n", count);
            check_near("solid angle", angle, 4 * GLM_PI, 1e-5);
            for (int n = 0; n < 4; n++) {
                double got = 0;
                for (int i = 0; i < count; i++)
                    got += (double)lights[i].radiance[0] * lambert(&lights[i], normals[n]);
                check_near("irradiance", got, .3 * GLM_PI, 1e-5);
            }
        }
    free(sky.texels);
}

static void middle_of(const struct environment_light *light, float middle[3]) {
    glm_vec3_zero(middle);
    for (int i = 0; i < 4; i++)
        glm_vec3_add(middle, (float *)light->corners[i], middle);
    vec3_unit(middle);
}

TEST(sun) {
    struct environment sky = make_sky(paint_sunny);
    for (int fit = 0; fit < FITS; fit++) {
        struct environment_light lights[ENVIRONMENT_LIGHTS_MAX];
        float middle[3];
        environment_fit(lights, &sky, (enum sky_fit)fit, 30);
        middle_of(&lights[0], middle);
        printf("  %s: %g sr of %g\n", fits[fit], (double)lights[0].solid_angle,
               (double)lights[0].radiance[0]);
        check_near("cosine to the sun", (double)glm_vec3_dot(middle, (float *)sun), 1, 2e-3);
        if (fit == 0) /* the sun has 9.4e-3 */
            check_at_most("as small as a few texels", (double)lights[0].solid_angle, .02);
    }
    free(sky.texels);
}

/* A quarter of its width on, a map's lights are the same, turned; and so they are with a turn of 90
 * degrees. */
TEST(turn) {
    struct environment sky = make_sky(paint_sunny), turned = make_sky(paint_sunny);
    for (int i = 0; i < WIDTH * HEIGHT; i++)
        glm_vec3_copy(sky.texels[i], turned.texels[i - i % WIDTH + (i + WIDTH * 3 / 4) % WIDTH]);
    sky.turn = 90;
    sky.strength = 2;
    struct environment_light lights[ENVIRONMENT_LIGHTS_MAX], others[ENVIRONMENT_LIGHTS_MAX];
    int count = environment_fit(lights, &sky, SKY_FIT_RECTANGLES, 30);
    assert_int_equal(environment_fit(others, &turned, SKY_FIT_RECTANGLES, 30), count);
    double farthest = 0, energy = 0;
    for (int i = 0; i < count; i++) {
        struct environment_light light = environment_light_turned(&lights[i], &sky);
        double nearest = 1;
        float middle[3], other[3];
        middle_of(&light, middle);
        for (int k = 0; k < count; k++) {
            middle_of(&others[k], other);
            double off = (double)glm_vec3_distance(middle, other) +
                         fabs((double)(light.solid_angle - others[k].solid_angle));
            if (off < nearest) {
                nearest = off;
                energy = (double)(others[k].radiance[2] / light.radiance[2]);
            }
        }
        farthest = fmax(farthest, nearest);
        check_near("radiance over its own", energy, .5, .02);
    }
    check_at_most("farthest from the same light, turned", farthest, 1e-4);
    /* What is seen there. */
    float at[3], direction[3];
    environment_direction(&sky, .7 * WIDTH, .3 * HEIGHT, direction);
    environment_radiance(&turned, direction, at);
    environment_radiance(&sky, direction, direction);
    check_near("what is seen where it is turned to", (double)direction[1], 2 * (double)at[1], 1e-5);
    mem_free(sky.texels, turned.texels);
}

/* A quarter of the sphere's face, seen face on. */
TEST(vector) {
    struct environment sky = make_sky(paint_even);
    struct environment_light lights[ENVIRONMENT_LIGHTS_MAX];
    int count = environment_fit(lights, &sky, SKY_FIT_EVEN, 48);
    double sum[3] = {0};
    for (int i = 0; i < count; i++) {
        float vector[3], middle[3];
        environment_light_vector(&lights[i], vector);
        middle_of(&lights[i], middle);
        check_near("face on", (double)glm_vec3_dot(vector, middle), lambert(&lights[i], middle),
                   1e-5);
        for (int c = 0; c < 3; c++)
            sum[c] += (double)vector[c];
    }
    for (int c = 0; c < 3; c++)
        check_near("of the whole sphere", sum[c], 0, 1e-5);
    free(sky.texels);
}

RUN_TESTS(NULL, NULL)
