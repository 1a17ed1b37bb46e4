/* Where reflected light starts: pieces of wide lights, what they have together, and that their
 * indirect light is that of the whole. */
#include "render_support.h"

#include "shared/vpl.h"

#include <cglm/cglm.h>

enum { SIZE = 64 };

static const struct environment_lights no_lights;
static const struct sky_groups no_groups;
static const struct light_samples_sky no_sky = {&no_lights, &no_groups};
static const struct light_samples_desc of_four = {.count = 4, .wide = .3F, .radius = 1};

static struct emitter lamp(enum emitter_type type, float width, float height) {
    struct emitter light = {.type = type,
                            .intensity = {3, 2, 1},
                            .size = {width, height},
                            .position = {.1F, .2F, -.1F},
                            .cos_outer = type == EMITTER_SPOT ? .5F : 0};
    emitter_aim(&light, (float[]){0, -1, 0});
    return light;
}

/* --- pieces ----------------------------------------------------------------------------------- */

/* Wide ones fall into pieces that have what the whole has, around its middle; others stay. */
TEST(pieces) {
    struct emitter lights[] = {lamp(EMITTER_AREA, .8F, .5F), lamp(EMITTER_AREA, .2F, .2F),
                               lamp(EMITTER_POINT, .9F, 0), lamp(EMITTER_SPOT, .5F, 0),
                               lamp(EMITTER_DIRECTIONAL, .0093F, 0)};
    static const int expected[] = {2, 1, 1, 2, 1};
    struct light_samples samples;
    light_samples_place(&samples, &(struct emitters){.items = lights, .count = 5}, &no_sky,
                        &of_four, 0);
    assert_int_equal(samples.group_count, 5);
    assert_int_equal(samples.count, 7);
    for (int g = 0; g < 5; g++) {
        struct light_group group = samples.groups[g];
        double flux = 0, middle[3] = {0};
        assert_int_equal(group.count, expected[g]);
        for (int i = group.first; i < group.first + group.count; i++) {
            flux += emitter_flux(&samples.items[i], 1);
            for (int c = 0; c < 3; c++)
                middle[c] += (double)samples.items[i].position[c] / group.count;
        }
        check_near("flux", flux, emitter_flux(&lights[g], 1), 1e-5 * flux);
        for (int c = 0; c < 3 && g != 3; c++) /* half disks have their middles aside */
            check_near("middle", middle[c], (double)lights[g].position[c], 1e-6);
        if (group.count == 1)
            assert_memory_equal(&samples.items[group.first], &lights[g], sizeof *lights);
    }
}

/* There is no more room than for lights and views; places are then fewer. */
TEST(room) {
    struct emitter lights[LIGHTS_MAX];
    struct light_samples_desc desc = {.count = LIGHTS_MAX, .wide = .3F, .radius = 1};
    struct light_samples samples;
    for (int i = 0; i < LIGHTS_MAX; i++)
        lights[i] = lamp(i ? EMITTER_DIRECTIONAL : EMITTER_AREA, i ? 0 : 1, i ? 0 : 1);
    light_samples_place(&samples, &(struct emitters){.items = lights, .count = 1}, &no_sky, &desc,
                        0);
    assert_int_equal(samples.count, LIGHT_VIEWS_MAX / 6);
    light_samples_place(&samples, &(struct emitters){.items = lights, .count = LIGHTS_MAX - 5},
                        &no_sky, &desc, 0);
    assert_int_equal(samples.count, LIGHTS_MAX);
    assert_int_equal(samples.groups[0].count, 6);
    light_samples_place(&samples, &(struct emitters){.items = lights, .count = LIGHTS_MAX}, &no_sky,
                        &desc, 0);
    assert_int_equal(samples.count, LIGHTS_MAX);
}

/* Each pass has as many places, others; those of many passes are even. */
TEST(passes) {
    enum { PASSES = 256 };
    struct emitter lights[] = {lamp(EMITTER_AREA, .8F, .5F), lamp(EMITTER_AREA, .2F, .2F)};
    struct light_samples samples;
    double sum[2] = {0}, square[2] = {0};
    for (int pass = 0; pass < PASSES; pass++) {
        light_samples_place(&samples, &(struct emitters){.items = lights, .count = 2}, &no_sky,
                            &of_four, pass);
        assert_int_equal(samples.count, 5);
        for (int i = 0; i < 5; i++) {
            double x = (double)(samples.items[i].position[0] - lights[0].position[0]);
            sum[i / 4] += x / (i < 4 ? 4 : 1) / PASSES;
            square[i / 4] += x * x / (i < 4 ? 4 : 1) / PASSES;
        }
    }
    for (int i = 0; i < 2; i++) {
        double width = (double)lights[i].size[0];
        check_near("mean place", sum[i], 0, .01 * width);
        check_near("its variance", square[i], width * width / 12, .01 * width * width);
    }
}

/* --- light ------------------------------------------------------------------------------------ */

/* In a sphere of albedo 1/2 VPLs have half of the flux, whatever they start from. */
TEST(flux) {
    const struct emitter lights[] = {lamp(EMITTER_AREA, 1, .8F), lamp(EMITTER_AREA, .9F, 0)};
    for (size_t i = 0; i < sizeof lights / sizeof *lights; i++) {
        OWNED(stage) stage = open_stage("scenes/sphere.glb");
        OWNED(renderer) renderer;
        stage.emitters.items[0] = lights[i];
        open_renderer(&renderer, desc_of(&stage, "unshadowed", "vpls=4096", 16, 16));
        assert_int_equal(renderer.plan.sample_layout.lights, 4);
        assert_int_equal(renderer.plan.sample_layout.groups, 1);
        struct vpl *vpls = read_vpls(&renderer);
        double sum = 0;
        for (int v = 0; v < 4096; v++)
            for (int c = 0; c < 3; c++)
                sum += (double)vpls[v].flux[c] / 3;
        double expected = .5 * emitter_flux(&stage.emitters.items[0], 1);
        check_near("flux of all VPLs", sum, expected, .01 * expected);
        free(vpls);
    }
}

/* A lamp of half the room's width: from its middle alone, as without a size, shadows are hard in
 * what lights the room. */
TEST(wide_lamp) {
    OWNED(stage) stage = open_stage("scenes/cornell-box.glb");
    struct emitter *spot = &stage.emitters.items[0];
    emitter_aim(spot, (float[]){0, -1, 0});
    glm_vec3_copy((vec3){0, 5.2F, 0}, spot->position);
    spot->size[0] = spot->size[1] = 2.8F;
    OWNED(image) reference = trace_stage(&stage, SIZE, 64);
    double errors[2];
    for (int i = 1; i >= 0; i--) {
        spot->size[0] = spot->size[1] = i ? 2.8F : 0;
        OWNED(image) got = render_stage(&stage, "clustered", "", SIZE);
        errors[i] = relative_rmse(&got, &reference, "indirect");
    }
    printf("    %-48s %g\n", "RMSE from its middle alone", errors[0]);
    check_at_most("from four places", errors[1], .75 * errors[0]);
}

RUN_TESTS(open_group_context, close_group_context)
