/* Several lights in one picture: each has the maps, the direct light and the VPLs that it would
 * have alone, and light adds up. */
#include "render_support.h"

#include "base/file/file.h"
#include "direct/direct.h"
#include "gl/memory.h"
#include "lights/view.h"
#include "techniques/technique.h"

enum { SIZE = 64 };

static const char *const three_lights = "scenes/three-lights.glb";

/* The stage with these lights alone, which are the test's. */
static struct image render_with(const struct stage *stage, struct emitter *lights, int count,
                                const char *technique, const char *settings) {
    struct renderer_desc desc = desc_of(stage, technique, settings, SIZE, SIZE);
    desc.emitters = (struct emitters){.items = lights, .count = count};
    return render_layers(&desc);
}

static void darken(struct emitter *light) {
    memset(light->intensity, 0, sizeof light->intensity);
}

/* --- maps ------------------------------------------------------------------------------------- */

/* Each view has a layer of its kind's maps, and those of a light follow each other. */
TEST(layout) {
    OWNED(stage) stage = open_stage(three_lights);
    struct emitter lights[6];
    static const int kinds[6] = {2, 0, 2, 1, 2, 0}; /* points 2, spots 0 and 1 */
    static struct light_block block;
    for (int i = 0; i < 6; i++)
        lights[i] = stage.emitters.items[kinds[i]];
    struct light_layout layout;
    struct emitters emitters = {.items = lights, .count = 6};
    check_ok("layout", light_layout_of(&layout, &emitters));
    views_of_emitters(&block, &emitters, &stage.geometry);
    assert_int_equal(layout.views[LIGHT_MAP_SINGLE], 3);
    assert_int_equal(layout.views[LIGHT_MAP_FACE], 18);
    assert_int_equal(block.single_count, 3);
    assert_int_equal(block.face_count, 18);
    for (int i = 0; i < 3 + 18; i++) {
        const struct light_view *view = &block.views[i];
        const struct light *light = &block.sources[view->light];
        assert_int_equal(view->kind, i < 3 ? LIGHT_MAP_SINGLE : LIGHT_MAP_FACE);
        assert_int_equal(view->layer, i < 3 ? i : i - 3);
        assert_int_equal(light->view_count, kinds[view->light] == 2 ? 6 : 1);
        assert_true(i >= light->first_view && i < light->first_view + light->view_count);
    }
    assert_int_equal(light_map_size(LIGHT_MAP_SINGLE, 511), 511);
    assert_int_equal(light_map_size(LIGHT_MAP_FACE, 511), 256);
}

/* A light that gives nothing beside another changes no bit: neither where its maps take room, nor
 * which VPLs the other has. */
TEST(dark_lights) {
    OWNED(stage) stage = open_stage(three_lights);
    static const struct {
        const char *what, *technique;
        int order[3];
    } rows[] = {{"a spot, clustered", "clustered", {0, 2, 1}},
                {"a point, clustered", "clustered", {2, 0, 1}},
                {"a point, unshadowed", "unshadowed", {2, 1, 0}}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const char *settings = "vpls=256 vals=8 map-size=64 rsm-size=128 shadow-size=512";
        struct emitter lights[3];
        for (int k = 0; k < 3; k++) {
            lights[k] = stage.emitters.items[rows[i].order[k]];
            if (k > 0)
                darken(&lights[k]);
        }
        OWNED(image) one = render_with(&stage, lights, 1, rows[i].technique, settings);
        OWNED(image) among = render_with(&stage, lights, 3, rows[i].technique, settings);
        bool same = same_pixels(&one, &among);
        printf("    %-30s %s\n", rows[i].what, same ? "the same bits" : "other bits");
        assert_true(same);
        assert_true(layer_mean(&one, "indirect") > 0);
    }
}

/* --- sums ------------------------------------------------------------------------------------- */

/* The layer's worst difference from the sum of the parts', over their greatest value. */
static double worst_difference(const struct image *whole, const struct image *parts, int count,
                               const char *layer) {
    int channels[3];
    double worst = 0, greatest = 0;
    assert_true(image_find_layer(whole, layer, channels));
    for (int i = 0; i < SIZE * SIZE; i++)
        for (int c = 0; c < 3; c++) {
            double sum = 0;
            for (int p = 0; p < count; p++)
                sum += image_at(&parts[p], i % SIZE, i / SIZE)[channels[c]];
            double value = image_at(whole, i % SIZE, i / SIZE)[channels[c]];
            worst = fmax(worst, fabs(value - sum));
            greatest = fmax(greatest, sum);
        }
    return worst / greatest;
}

/* Adds the parts into the first. */
static struct image *add_up(struct image *parts, int count) {
    size_t values = (size_t)SIZE * SIZE * (size_t)parts->channel_count;
    for (int p = 1; p < count; p++)
        for (size_t i = 0; i < values; i++)
            parts[0].pixels[i] += parts[p].pixels[i];
    return parts;
}

/* Without visibility the sum over VPLs is linear; each light has about a third of them in the sum,
 * and all of them alone. */
TEST(sum) {
    struct image parts[3];
    const char *settings = "vpls=8192 interleave=1 near-samples=256 shadow-size=1024";
    OWNED(stage) stage = open_stage(three_lights);
    struct emitter *lights = stage.emitters.items;
    struct image whole = render_with(&stage, lights, 3, "unshadowed", settings);
    for (int i = 0; i < 3; i++)
        parts[i] = render_with(&stage, &lights[i], 1, "unshadowed", settings);
    check_at_most("direct light, worst difference", worst_difference(&whole, parts, 3, "direct"),
                  1e-6);
    double mean = 0;
    for (int i = 0; i < 3; i++)
        mean += layer_mean(&parts[i], "indirect");
    check_near("indirect light, mean", layer_mean(&whole, "indirect"), mean, .003 * mean);
    struct image *sum = add_up(parts, 3);
    check_at_most("indirect light, relative RMSE", relative_rmse(&whole, sum, "indirect"), .02);
    image_free(&whole);
    for (int i = 0; i < 3; i++)
        image_free(&parts[i]);
}

/* A light in two halves at one place is the one; the halves' VPLs lie between each other. */
TEST(split) {
    const char *settings = "vpls=4096 interleave=1 near-samples=256 shadow-size=512";
    OWNED(stage) stage = open_stage(three_lights);
    for (int i = 0; i < 3; i += 2) {
        struct emitter whole = stage.emitters.items[i], halves[2] = {whole, whole};
        for (int c = 0; c < 3; c++)
            halves[0].intensity[c] = halves[1].intensity[c] = whole.intensity[c] / 2;
        OWNED(image) one = render_with(&stage, &whole, 1, "unshadowed", settings);
        OWNED(image) two = render_with(&stage, halves, 2, "unshadowed", settings);
        check_at_most("direct light, worst difference", worst_difference(&two, &one, 1, "direct"),
                      1e-6);
        double mean = layer_mean(&one, "indirect");
        check_near("indirect light, mean", layer_mean(&two, "indirect"), mean, .003 * mean);
        check_at_most("indirect light, relative RMSE", relative_rmse(&two, &one, "indirect"), .04);
    }
}

/* --- reference -------------------------------------------------------------------------------- */

/* Against the path tracer, by the pixels' centres: both have all three lights. In so small a
 * picture the Cornell box under one spot is 17 and 9 % off. */
TEST(reference) {
    OWNED(stage) stage = open_stage(three_lights);
    OWNED(image) reference = trace_stage(&stage, SIZE, is_long_run() ? 256 : 64);
    static const struct {
        const char *technique, *settings;
        double direct, mean, indirect;
    } rows[] = {
        {"clustered", "", .01, .04, .2},
        {"instant-radiosity", "vpls=4096 interleave=1", .01, .02, .09},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        if (!is_tried_here(i, 2))
            continue;
        struct image image =
            render_with(&stage, stage.emitters.items, 3, rows[i].technique, rows[i].settings);
        printf("  %s %s\n", rows[i].technique, rows[i].settings);
        double mean = layer_mean(&reference, "direct");
        check_near("direct light, mean", layer_mean(&image, "direct"), mean, .005 * mean);
        check_at_most("direct light, relative RMSE", relative_rmse(&image, &reference, "direct"),
                      rows[i].direct);
        mean = layer_mean(&reference, "indirect");
        check_near("indirect light, mean", layer_mean(&image, "indirect"), mean,
                   rows[i].mean * mean);
        check_at_most("indirect light, relative RMSE",
                      relative_rmse(&image, &reference, "indirect"), rows[i].indirect);
        image_free(&image);
    }
}

/* --- too many --------------------------------------------------------------------------------- */

TEST(too_many) {
    struct renderer renderer;
    struct emitter lights[LIGHTS_MAX + 1];
    OWNED(stage) stage = open_stage(three_lights);
    struct renderer_desc desc =
        desc_of(&stage, "imperfect-volume", "rsm-size=16 shadow-size=16", 8, 8);
    for (int i = 0; i <= LIGHTS_MAX; i++)
        lights[i] = stage.emitters.items[0];
    desc.emitters = (struct emitters){.items = lights, .count = LIGHTS_MAX + 1};
    assert_false(renderer_init(&renderer, &desc));
    assert_string_equal(error_get(), "65 lights with 65 views: at most 64 with 384 shine at once; "
                                     "--light picks some");
    desc.emitters.count = LIGHTS_MAX;
    check_ok("as many as there may be", renderer_init(&renderer, &desc));
    renderer_render(&renderer);
    for (int i = 0; i <= LIGHTS_MAX; i++)
        lights[i] = stage.emitters.items[2];
    desc.emitters.count = LIGHTS_MAX + 1;
    assert_false(renderer_follow(&renderer, &desc));
    assert_string_equal(error_get(), "65 lights with 390 views: at most 64 with 384 shine at once; "
                                     "--light picks some");
    renderer_render(&renderer);
    desc.emitters.count = LIGHTS_MAX;
    check_ok("64 points", renderer_follow(&renderer, &desc));
    renderer_render(&renderer);
    renderer_free(&renderer);
    assert_int_equal(gpu_memory_total(), 0);
}

/* --- as many points as there may be ----------------------------------------------------------- */

/* A point's share of a light for each: all together are that light. */
static void split_point(const struct stage *stage, struct emitter lights[LIGHTS_MAX]) {
    for (int i = 0; i < LIGHTS_MAX; i++) {
        lights[i] = stage->emitters.items[2];
        for (int c = 0; c < 3; c++)
            lights[i].intensity[c] /= LIGHTS_MAX;
    }
}

static void check_points(const struct stage *stage, const struct technique *technique,
                         const struct direct_method *direct, const char *settings) {
    struct emitter lights[LIGHTS_MAX], one = stage->emitters.items[2];
    int size = is_long_run() ? SIZE : SIZE / 2;
    struct renderer_desc desc = desc_of(stage, technique->name, settings, size, size);
    desc.direct = direct;
    split_point(stage, lights);
    desc.emitters = (struct emitters){.items = lights, .count = LIGHTS_MAX};
    struct image many = render_layers(&desc);
    desc.emitters = (struct emitters){.items = &one, .count = 1};
    struct image single = render_layers(&desc);
    check_near("direct light", layer_mean(&many, "direct") / layer_mean(&single, "direct"), 1, .02);
    check_near(technique->name, layer_mean(&many, "indirect") / layer_mean(&single, "indirect"), 1,
               .1);
    images_free(&many, &single);
}

TEST(points) {
    OWNED(stage) stage = open_stage(three_lights);
    for (const struct technique *const *technique = techniques; *technique; technique++)
        check_points(&stage, *technique, direct_methods[0],
                     is_long_run() ? "vpls=1024 rsm-size=64 shadow-size=256"
                                   : "vpls=1024 rsm-size=64 shadow-size=128");
    for (size_t i = 0; direct_methods[i]; i++) {
        if (!is_tried_here(i, 2))
            continue;
        printf("%s\n", direct_methods[i]->name);
        check_points(&stage, technique_find("unshadowed"), direct_methods[i],
                     is_long_run() ? "vpls=1024 rsm-size=64 shadow-size=256"
                                   : "vpls=256 rsm-size=64 shadow-size=256");
    }
}

/* Maps of many views are smaller. */
TEST(map_share) {
    assert_int_equal(light_map_share(2048, 32, 32), 2048);
    assert_int_equal(light_map_share(2048, 128, 32), 1024);
    assert_int_equal(light_map_share(32, 1000, 1), 16);
}

TEST(case) {
    if (!shared_path())
        return;
    const char *path = form("%s/cases/lights-43/points.gltf", shared_path());
    if (!file_can_be_read(path))
        return;
    struct stage stage = open_stage(path);
    OWNED(image) image = render_stage(&stage, "clustered", "shadow-size=128 rsm-size=64", SIZE);
    int red = image_find_channel(&image, "direct.R");
    check_near("43 points", (double)image_at(&image, SIZE / 2, SIZE / 2)[red], 1, .005);
    stage_free(&stage);
}

RUN_TESTS(open_group_context, close_group_context)
