/* Slides: pictures in spots. Exact answers of a chart on a floor, the path tracer, relations, and
 * what is refused. */
#include "smooth_stage.h"

#include "tiny_png.h"

#include "scene/lights/slide.h"
#include "scene/open.h"

#include <cglm/cglm.h>

/* --- scenes ----------------------------------------------------------------------------------- */

enum { CHART = 64 }; /* pixels a side */

static const unsigned char corners[2][2][3] = {{{255, 0, 0}, {0, 255, 0}},
                                               {{0, 0, 255}, {255, 255, 0}}};

/* One for each of the first lights. */
static void set_slides_of(struct stage *stage, const struct bitmap *bitmaps, int count) {
    struct scene *scene = &stage->scene;
    for (int i = 0; i < scene->slide_count; i++)
        slide_free(&scene->slides[i]);
    free(scene->slides);
    scene->slides = mem_alloc((size_t)count, sizeof *scene->slides);
    scene->slide_count = count;
    for (int i = 0; i < count; i++) {
        slide_init(&scene->slides[i], i, &bitmaps[i]);
        stage->emitters.items[i].slide = &scene->slides[i];
    }
}

static void set_slide_of(struct stage *stage, const struct bitmap *bitmap) {
    set_slides_of(stage, bitmap, 1);
}

/* A square of a colour in each corner; or white. */
static void set_slide(struct stage *stage, bool is_white) {
    unsigned char rgba[CHART * CHART * 4];
    struct bitmap bitmap = {.width = CHART, .height = CHART, .rgba = rgba};
    for (int i = 0; i < CHART * CHART; i++)
        for (int c = 0; c < 4; c++)
            rgba[4 * i + c] = is_white || c == 3
                                  ? 255
                                  : corners[i / CHART / (CHART / 2)][i % CHART / (CHART / 2)][c];
    set_slide_of(stage, &bitmap);
}

/* A floor that the whole cone falls onto, from above, turned. */
static void open_floor(struct stage *stage) {
    open_nodes(stage, FLOOR_NODE, 2.5F);
    struct emitter *light = &stage->emitters.items[0];
    light->cos_outer = cosf(.7F);
    light->cos_inner = cosf(.65F);
    emitter_aim(light, (float[]){.3F, .1F, -1});
    stage->camera.fov_y = glm_rad(75);
}

static double value_at(const struct image *image, int x, int y, const char *channel) {
    int c = image_find_channel(image, channel);
    assert_true(c >= 0);
    return (double)image_at(image, x, y)[c];
}

/* --- exact answers ---------------------------------------------------------------------------- */

/* Where the pixel's place lies on the slide, from -1 to 1, to the right and up as the
 * light looks. */
static void place_on_slide(const struct stage *stage, int x, int y, double place[2]) {
    const struct emitter *light = &stage->emitters.items[0];
    double half = 2.5 * tan(glm_rad(75) / 2);
    vec3 at = {(float)(((x + .5) / SIZE * 2 - 1) * half), (float)((1 - (y + .5) / SIZE * 2) * half),
               0};
    vec3 way;
    glm_vec3_sub(at, (float *)light->position, way);
    double ahead = (double)glm_vec3_dot(way, (float *)light->direction) * tan(.7);
    place[0] = (double)glm_vec3_dot(way, (float *)light->right) / ahead;
    place[1] = (double)glm_vec3_dot(way, (float *)light->up) / ahead;
}

/* Each pixel of the floor has the light without a slide, times the colour that the slide
 * has there. */
TEST(chart) {
    static const char *const channels[] = {"direct.R", "direct.G", "direct.B"};
    OWNED(stage) stage;
    int checked = 0, lit[4] = {0};
    double worst = 0;
    open_floor(&stage);
    OWNED(image) plain = draw(&stage, CHEAP);
    set_slide(&stage, false);
    OWNED(image) drawn = draw(&stage, CHEAP);
    for (int i = 0; i < SIZE * SIZE; i++) {
        double place[2];
        int x = i % SIZE, y = i / SIZE;
        place_on_slide(&stage, x, y, place);
        double full = value_at(&plain, x, y, channels[0]);
        if (full <= 0 || fabs(place[0]) < .05 || fabs(place[1]) < .05)
            continue;
        int row = place[1]<0, column = place[0]> 0;
        for (int c = 0; c < 3; c++)
            worst = fmax(worst, fabs(value_at(&drawn, x, y, channels[c]) / full -
                                     corners[row][column][c] / 255.));
        lit[2 * row + column]++;
        checked++;
    }
    printf("    %d pixels, of the four colours %d, %d, %d, %d\n", checked, lit[0], lit[1], lit[2],
           lit[3]);
    check_at_most("largest error of a pixel, over the light", worst, 1e-3);
    assert_true(lit[0] > 50 && lit[1] > 50 && lit[2] > 50 && lit[3] > 50);
}

/* A white slide is none, bit for bit, in all that lights do. */
TEST(white) {
    static const char settings[] =
        CHEAP "caustics.surface=patches caustics.medium=lines caustics.size=64 medium.scatter=.3";
    static const char *const names[] = {"unshadowed", "clustered", "implicit-visibility"};
    OWNED(stage) stage;
    open_slab(&stage, 1.5F, 1, .75F);
    stage.camera.fov_y = glm_rad(130);
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        stage.emitters.items[0].slide = NULL;
        OWNED(image) without = render_stage(&stage, names[i], settings, SIZE);
        set_slide(&stage, true);
        OWNED(image) with = render_stage(&stage, names[i], settings, SIZE);
        printf("    %s: caustic %g, volume %g\n", names[i], mean_of(&with, "caustic"),
               mean_of(&with, "volume"));
        assert_true(same_pixels(&with, &without));
    }
}

/* --- other light ------------------------------------------------------------------------------ */

/* Layers of a chart in fog between walls, by the path tracer. */
TEST(traced) {
    OWNED(stage) stage = open_stage("scenes/cornell-box.glb");
    static const char *const channels[] = {"direct.R",   "direct.G",   "direct.B",
                                           "airlight.R", "airlight.G", "airlight.B",
                                           "indirect.R", "indirect.G", "indirect.B"};
    for (int c = 0; c < 3; c++)
        stage.scene.medium.scattering[c] = .05F;
    set_slide(&stage, false);
    OWNED(image) drawn = render_stage(&stage, "instant-radiosity", "vpls=1024 rsm-size=256", SIZE);
    OWNED(image) traced =
        TRACE(&stage, .width = SIZE, .height = SIZE, .samples = 64, .bounces = 1,
              .materials = MATERIALS_FULL, .centers = true, .medium = stage.scene.medium);
    for (size_t i = 0; i < sizeof channels / sizeof *channels; i++)
        check_near(channels[i],
                   channel_mean(&drawn, channels[i]) / channel_mean(&traced, channels[i]), 1,
                   i < 3   ? .02
                   : i < 6 ? .03
                           : .08);
}

/* Glass that bends nothing: what was direct light of the slide is a caustic of it, on the floor and
 * in the medium. */
TEST(caustic) {
    static const char *const channels[] = {"R", "G", "B"};
    OWNED(stage) with, without;
    open_slab(&with, 1, 1, .75F);
    open_nodes(&without, FLOOR_NODE, .75F);
    struct stage *const both[] = {&with, &without};
    for (int i = 0; i < 2; i++) {
        both[i]->camera.fov_y = glm_rad(130);
        both[i]->scene.medium = (struct medium){.scattering = {.1F, .1F, .1F}};
        both[i]->emitters.items[0].cos_outer = cosf(.5F);
        both[i]->emitters.items[0].cos_inner = cosf(.45F);
        set_slide(both[i], false);
    }
    for (int c = 0; c < 3; c++) /* as much as the medium takes, which is not in glass */
        with.scene.materials[SMOOTH].absorption[c] = .1F;
    OWNED(image) a =
        draw(&with, CHEAP
             "caustics.surface=patches caustics.medium=lines caustics.size=256 medium.steps=128");
    OWNED(image) b = draw(&without, CHEAP "medium.steps=128");
    for (int c = 0; c < 3; c++) {
        const char *direct = form("direct.%s", channels[c]);
        const char *caustic = form("caustic.%s", channels[c]);
        const char *airlight = form("airlight.%s", channels[c]);
        const char *volume = form("volume.%s", channels[c]);
        printf("    %s\n", channels[c]);
        check_near("on surfaces, with over without",
                   (channel_mean(&a, direct) + channel_mean(&a, caustic)) /
                       channel_mean(&b, direct),
                   1, .02);
        check_near("in the medium, with over without",
                   (channel_mean(&a, airlight) + channel_mean(&a, volume)) /
                       channel_mean(&b, airlight),
                   1, .03);
    }
}

/* A slide of one colour leaves out the light of the others: with all techniques and
 * direct methods. */
static void check_magenta(const struct stage *stage, const char *technique,
                          const struct direct_method *direct) {
    struct renderer_desc desc = desc_of(stage, technique, CHEAP "samples=1", 24, 24);
    desc.direct = direct;
    struct image image = render_layers(&desc);
    printf("    %s, %s\n", technique, direct ? direct->name : "default");
    check_near("direct, green", channel_mean(&image, "direct.G"), 0, 0);
    check_near("indirect, green", channel_mean(&image, "indirect.G"), 0, 0);
    assert_true(channel_mean(&image, "direct.R") > 0 && channel_mean(&image, "indirect.R") > 0);
    image_free(&image);
}

TEST(everywhere) {
    unsigned char magenta[4] = {255, 0, 255, 255};
    OWNED(stage) stage = open_stage("scenes/cornell-box.glb");
    set_slide_of(&stage, &(struct bitmap){.width = 1, .height = 1, .rgba = magenta});
    for (const struct technique *const *t = techniques; *t; t++)
        check_magenta(&stage, (*t)->name, NULL);
    for (const struct direct_method *const *d = direct_methods; *d; d++)
        check_magenta(&stage, "unshadowed", *d);
}

/* Specular rays that look up maps read the most textures of all passes, and a slide is one more. */
TEST(specular_maps) {
    static const char *const techniques_of_maps[][2] = {
        {"cluster-lights", CHEAP}, {"clustered", CHEAP "path=paper lights.importance=on"}};
    unsigned char magenta[4] = {255, 0, 255, 255};
    OWNED(stage) stage = open_stage("scenes/ring.glb");
    set_slide_of(&stage, &(struct bitmap){.width = 1, .height = 1, .rgba = magenta});
    for (int i = 0; i < 2; i++) {
        struct image image =
            render_stage(&stage, techniques_of_maps[i][0], techniques_of_maps[i][1], 24);
        printf("    %s %s\n", techniques_of_maps[i][0], techniques_of_maps[i][1]);
        check_finite("layers", &image);
        check_near("direct, green", channel_mean(&image, "direct.G"), 0, 0);
        image_free(&image);
    }
}

/* Two spots, each with its slide, of other sizes: a red and a green one. Red light is the first
 * spot's alone. Steps of airlight begin elsewhere for each light. */
TEST(two_spots) {
    unsigned char red[4] = {255, 0, 0, 255}, green[8] = {0, 255, 0, 255, 0, 255, 0, 255};
    const struct bitmap bitmaps[] = {{.width = 1, .height = 1, .rgba = red},
                                     {.width = 2, .height = 1, .rgba = green}};
    static const char *const channels[] = {"direct.R", "direct.G", "direct.B"};
    static const char settings[] = CHEAP "medium.scatter=.3";
    OWNED(stage) stage;
    open_floor(&stage);
    struct emitter lights[2] = {stage.emitters.items[0], stage.emitters.items[0]};
    lights[1].position[0] = .4F;
    emitter_aim(&lights[1], (float[]){-.3F, -.2F, -1});
    free(stage.emitters.items);
    struct image alone[2];
    for (int i = 0; i < 2; i++) {
        stage.emitters = (struct emitters){.items = &lights[i], .count = 1};
        alone[i] = draw(&stage, settings);
    }
    stage.emitters = (struct emitters){.items = mem_alloc(2, sizeof *lights), .count = 2};
    memcpy(stage.emitters.items, lights, sizeof lights);
    set_slides_of(&stage, bitmaps, 2);
    OWNED(image) both = draw(&stage, settings);
    for (int c = 0; c < 3; c++) {
        double expected = c < 2 ? channel_mean(&alone[c], channels[c]) : 0;
        check_near(channels[c], channel_mean(&both, channels[c]) - expected, 0, 1e-4 * expected);
    }
    check_near("airlight, red over the first spot's",
               channel_mean(&both, "airlight.R") / channel_mean(&alone[0], "airlight.R"), 1, .02);
    check_near("airlight, green over the second's",
               channel_mean(&both, "airlight.G") / channel_mean(&alone[1], "airlight.G"), 1, .02);
    check_near("airlight, blue", channel_mean(&both, "airlight.B"), 0, 0);
    for (int i = 0; i < 2; i++)
        image_free(&alone[i]);
}

/* The mean over passes has the colours of one frame. */
TEST(passes) {
    static const char *const channels[] = {"direct.R", "direct.G", "direct.B"};
    OWNED(stage) stage;
    open_floor(&stage);
    set_slide(&stage, false);
    struct renderer_desc desc = desc_of(&stage, "clustered", CHEAP, SIZE, SIZE);
    OWNED(image) one = render_layers(&desc), mean = render_mean(&desc, 0, 4);
    for (int c = 0; c < 3; c++)
        check_near(channels[c], channel_mean(&mean, channels[c]) / channel_mean(&one, channels[c]),
                   1, .01);
}

/* --- files ------------------------------------------------------------------------------------ */

/* A light with these extras, and textures of a picture of two pixels, red and green, and of none */
static bool open_file(struct scene *scene, struct geometry *geometry, const char *light,
                      const char *extras, const char *picture) {
    static const unsigned char two[8] = {255, 0, 0, 255, 0, 255, 0, 255};
    char more[1024];
    write_tiny_png(scratch("slide.png"), two, 2, 1);
    write_bytes(scratch("broken.png"), two, sizeof two);
    snprintf(more, sizeof more,
             "extensionsUsed: [KHR_lights_punctual], images: [{uri: '%s'}], textures: [{source: "
             "0}, {}], extensions: {KHR_lights_punctual: {lights: [{%s, extras: %s}]}},",
             picture, light, extras);
    const char *path = write_parts(
        "slide.glb",
        &PARTS(.more = more,
               .nodes = "[{mesh: 0}, {extensions: {KHR_lights_punctual: {light: 0}}}]"));
    return scene_open(scene, geometry, path, NULL);
}

#define SPOT "type: spot, spot: {outerConeAngle: 0.5}"

TEST(file) {
    OWNED(scene) scene;
    OWNED(geometry) geometry;
    check_ok("opened", open_file(&scene, &geometry, SPOT, "{texture: {index: 0}}", "slide.png"));
    OWNED(emitters) emitters = emitters_place(&scene, 0);
    assert_non_null(emitters.items[0].slide);
    for (int side = 0; side < 2; side++) { /* a light looks along -z, its right is x */
        float rgb[3], direction[3] = {side ? .4F : -.4F, 0, -.9F};
        emitter_slide(&emitters.items[0], direction, rgb);
        check_near("red", (double)rgb[0], !side, 1e-6);
        check_near("green", (double)rgb[1], side, 1e-6);
    }
}

/* A JPEG of a red and a green block of 8 x 8 pixels. */
TEST(jpeg) {
    unsigned char rgba[4 * 16 * 8] = {0};
    OWNED(scene) scene;
    OWNED(geometry) geometry;
    for (int i = 0; i < 16 * 8; i++)
        rgba[4 * i + (i % 16 >= 8)] = rgba[4 * i + 3] = 255;
    check_ok("written", bitmap_write(&(struct bitmap){.width = 16, .height = 8, .rgba = rgba},
                                     scratch("slide.jpg")));
    check_ok("opened", open_file(&scene, &geometry, SPOT, "{texture: {index: 0}}", "slide.jpg"));
    OWNED(emitters) emitters = emitters_place(&scene, 0);
    assert_non_null(emitters.items[0].slide);
    check_near("width", emitters.items[0].slide->width, 16, 0);
    for (int side = 0; side < 2; side++) {
        float rgb[3], direction[3] = {side ? .4F : -.4F, 0, -.9F};
        emitter_slide(&emitters.items[0], direction, rgb);
        check_near("red", (double)rgb[0], !side, .03); /* a JPEG's colours are rounded */
        check_near("green", (double)rgb[1], side, .03);
    }
}

TEST(refused) {
    static const struct {
        const char *light, *extras, *message, *picture;
    } rows[] = {
        {SPOT, "{texture: {index: 0}}", "image 0", "missing.png"},
        {SPOT, "{texture: {index: 0}}", "image 0", "broken.png"},
        {SPOT, "{texture: {index: 7}}", "a texture of the file", "slide.png"},
        {SPOT, "{texture: {index: 1}}", "with a picture", "slide.png"},
        {SPOT, "{texture: {index: -1}}", "a texture of the file", "slide.png"},
        {SPOT, "{texture: 'slide.png'}", "a texture of the file", "slide.png"},
        {"type: point", "{texture: {index: 0}}", "only a spot", "slide.png"},
        {"type: spot, spot: {outerConeAngle: 1.5}", "{texture: {index: 0}}", "half angle",
         "slide.png"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct scene scene;
        struct geometry geometry;
        bool opened = open_file(&scene, &geometry, rows[i].light, rows[i].extras, rows[i].picture);
        check_refused(opened, rows[i].message);
        check_refused(opened, "extras: texture: ");
    }
}

RUN_TESTS(open_group_context, close_group_context)
