/* What there is to look at: the list of outputs, their pictures, and the pixel that is
 * clicked on. */
#include "gltf_parts.h"
#include "render_support.h"

#include "gl/glsl.h"
#include "inspect/inspect.h"
#include "inspect/probe.h"

#include <cglm/cglm.h>
static const char small[] = "vpls=64 vals=6 map-size=32 rsm-size=64 shadow-size=128 interleave=4";

static void open_frame(struct stage *stage, struct renderer *renderer, const char *technique,
                       const char *settings) {
    const char *all = form("%s %s", small, settings);
    *stage = open_stage("scenes/cornell-box.glb");
    struct renderer_desc desc = desc_of(stage, technique, all, 48, 32);
    open_renderer(renderer, desc);
}

static void close_frame(struct stage *stage, struct renderer *renderer) {
    renderer_free(renderer);
    stage_free(stage);
}

static struct inspect_choice choice_of(const char *output) {
    return (struct inspect_choice){
        .output = output, .layer = -1, .chosen = -1, .width = 96, .height = 64, .scale = 1};
}

/* --- outputs ---------------------------------------------------------------------------------- */

static int count_shades(const struct texture *canvas) {
    OWNED(bitmap) picture;
    bool seen[256] = {false};
    int count = 0;
    texture_read_bitmap(canvas, &picture);
    for (int i = 0; i < picture.width * picture.height; i++) {
        count += !seen[picture.rgba[4 * i + 1]];
        seen[picture.rgba[4 * i + 1]] = true;
    }
    return count;
}

/* Each output that a technique lists is a picture, as a whole and of its last layer. */
static void check_pictures(const char *technique, const char *settings) {
    struct stage stage;
    struct renderer renderer;
    struct inspect inspect;
    struct output_list outputs;
    open_frame(&stage, &renderer, technique, settings);
    check_ok("inspect", inspect_init(&inspect));
    renderer_outputs(&renderer, &outputs);
    for (int i = 0; i < outputs.count; i++) {
        const char *name = outputs.items[i].name;
        struct inspect_choice choice = choice_of(name);
        int layers = inspect_layers(&renderer, name);
        check_ok(name, inspect_draw(&inspect, &renderer, &choice));
        printf("    %-18s %-12s %d layers, %dx%d, %d shades\n", technique, name, layers,
               inspect.canvas.desc.width, inspect.canvas.desc.height,
               count_shades(&inspect.canvas));
        /* Irradiance may be the same everywhere: one shade and the background's. */
        int least = outputs.items[i].kind == OUTPUT_IRRADIANCE ? 2 : 3;
        if (count_shades(&inspect.canvas) < least)
            fail_msg("output '%s' of %s is drawn in too few shades: has its kind a row in mode_of "
                     "and a case in texture_of (src/inspect/inspect.c), and one in "
                     "src/inspect/inspect.frag?",
                     name, technique);
        choice.layer = layers - 1;
        check_ok(name, inspect_draw(&inspect, &renderer, &choice));
        assert_int_equal(strspn(name, "abcdefghijklmnopqrstuvwxyz-"), strlen(name));
    }
    inspect_free(&inspect);
    close_frame(&stage, &renderer);
}

TEST(pictures) {
    check_pictures("clustered", "visibility=cssm");
    for (const struct technique *const *t = techniques; *t; t++)
        check_pictures((*t)->name, "");
}

TEST(missing) {
    struct stage stage;
    struct renderer renderer;
    struct inspect inspect;
    struct inspect_choice choice = choice_of("visibility");
    open_frame(&stage, &renderer, "unshadowed", "");
    check_ok("inspect", inspect_init(&inspect));
    assert_int_equal(inspect_layers(&renderer, "visibility"), 0);
    assert_null(inspect_find(&renderer, OUTPUT_VALS));
    assert_string_equal(inspect_find(&renderer, OUTPUT_VPLS), "vpl");
    assert_false(inspect_draw(&inspect, &renderer, &choice));
    assert_string_equal(error_get(), "technique 'unshadowed' has no output 'visibility'");
    inspect_free(&inspect);
    close_frame(&stage, &renderer);
}

/* A view that is drawn again reads no shader; one of another lookup does. */
TEST(shaders_kept) {
    struct stage stage;
    struct renderer renderer;
    struct inspect inspect;
    struct inspect_choice choice = choice_of("visibility");
    open_frame(&stage, &renderer, "clustered", "");
    check_ok("inspect", inspect_init(&inspect));
    check_ok("first", inspect_draw(&inspect, &renderer, &choice));
    glsl_set_folder("/nowhere");
    bool again = inspect_draw(&inspect, &renderer, &choice);
    glsl_set_folder(NULL);
    check_ok("again", again);
    struct renderer_desc other = renderer.desc;
    check_ok("setting", settings_assign(&other.settings, "visibility=hard"));
    check_ok("change", renderer_follow(&renderer, &other));
    renderer_render(&renderer);
    glsl_set_folder("/nowhere");
    bool changed = inspect_draw(&inspect, &renderer, &choice);
    glsl_set_folder(NULL);
    assert_false(changed);
    check_ok("after all", inspect_draw(&inspect, &renderer, &choice));
    inspect_free(&inspect);
    close_frame(&stage, &renderer);
}

/* --- light in numbers ------------------------------------------------------------------------- */

/* 9 cd, .5 m before a white square, which lights nothing else: E = I h / d^3 and L = E / pi, as
 * values and as colours of the scale. */
TEST(light) {
    static const struct {
        const char *output, *title;
        enum light_unit unit;
        double factor;
    } rows[] = {
        {"illuminance", "lux", LIGHT_RADIANCE, 179},
        {"illuminance", "W/m2", LIGHT_WATTS, 1},
        {"luminance", "cd/m2", LIGHT_CANDELA, GLM_1_PI},
    };
    struct stage stage = open_stage(write_parts("square.glb", &(struct gltf_parts){0}));
    struct emitter *lamp = stage.emitters.items;
    struct renderer renderer;
    struct inspect inspect;
    OWNED(image) layers;
    *lamp = emitter_new(EMITTER_POINT);
    stage.emitters.count = 1; /* the file has no light, and stand-ins shine */
    for (int c = 0; c < 3; c++) {
        lamp->position[c] = .5F;
        lamp->intensity[c] = 9;
    }
    open_renderer(&renderer, desc_of(&stage, "clustered", small, 48, 32));
    check_ok("inspect", inspect_init(&inspect));
    check_ok("layers", renderer_read_layers(&renderer, &layers));
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct inspect_choice choice = choice_of(rows[i].output);
        OWNED(bitmap) picture;
        double worst = 0;
        choice.unit = rows[i].unit;
        choice.top = (float)(30 * rows[i].factor);
        check_ok(rows[i].output, inspect_draw(&inspect, &renderer, &choice));
        const struct heat_map *light = inspect_light(&inspect, &choice);
        texture_read_bitmap(&inspect.canvas, &picture);
        for (int k = 0; k < 48 * 32; k++) {
            bool is_square = image_at(&layers, k % 48, k / 48)[3] > 0;
            float p[3];
            unsigned char color[3];
            pixel_position(&renderer, &layers, k % 48, k / 48, p);
            double away = (double)glm_vec3_distance(p, lamp->position);
            double expected = is_square ? 4.5 / pow(away, 3) : 0;
            worst = fmax(worst, fabs((double)light->values[k] / rows[i].factor - expected));
            heat_map_color(light, light->values[k], color);
            assert_memory_equal(picture.rgba + 4 * k, color, 3);
        }
        check_at_most(light->title, worst, .1);
        assert_string_equal(light->title, rows[i].title);
        assert_true(light->top == choice.top);
    }
    inspect_free(&inspect);
    close_frame(&stage, &renderer);
}

/* --- a pixel ---------------------------------------------------------------------------------- */

/* What is told of a place is what the layers have there. */
TEST(pick) {
    struct stage stage;
    struct renderer renderer;
    struct probe probe = {0};
    struct image layers;
    open_frame(&stage, &renderer, "clustered", "");
    check_ok("layers", renderer_read_layers(&renderer, &layers));
    static const char *const names[] = {"R", "direct.R", "indirect.R", "albedo.R", "normal.X"};
    int lit = 0;
    for (int i = 0; i < 6; i++) {
        int x = 4 + 8 * i, y = 3 + 5 * i;
        struct pick pick;
        check_ok("pick", probe_pick(&probe, &renderer, ((float)x + .5F) / 48, ((float)y + .5F) / 32,
                                    &pick));
        const float *told[] = {pick.radiance, pick.direct, pick.indirect, pick.albedo, pick.normal};
        const float *pixel = image_at(&layers, x, y);
        for (int k = 0; k < 5; k++)
            assert_memory_equal(told[k], pixel + image_find_channel(&layers, names[k]),
                                3 * sizeof(float));
        float position[3], away = 0;
        pixel_position(&renderer, &layers, x, y, position);
        for (int c = 0; c < 3; c++)
            away = fmaxf(away, fabsf(position[c] - pick.position[c]));
        check_at_most("position, metres", (double)away, 1e-5);
        float shares = 0;
        for (int k = 0; k < pick.val_count; k++)
            shares += pick.vals[k].share;
        if (pick.val_count)
            check_near("shares of all VALs", (double)shares, 1, 1e-4);
        lit += pick.val_count > 0;
    }
    assert_true(lit > 2);
    image_free(&layers);
    probe_free(&probe);
    close_frame(&stage, &renderer);
}

RUN_TESTS(open_group_context, close_group_context)
