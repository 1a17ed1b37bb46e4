/* Which clips of a file play: all that go together, the first of alternatives, or those that are
 * chosen. */
#define _XOPEN_SOURCE 700
#include "command_support.h"
#include "gltf_parts.h"

#include "scene/animation.h"
#include "scene/clips.h"
#include "scene/mesh/geometry.h"
#include "scene/node.h"
#include "scene/open.h"

/* Two samplers move things from 0 to 4 m along x: in 1 s, and in 2 s. */
static const float keys[] = {0, 1, 0, 2, 0, 0, 0, 4, 0, 0};

#define ACCESSORS                                                                                  \
    "[" PARTS_QUAD                                                                                 \
    ", {bufferView: 0, byteOffset: 64, componentType: 5126, count: 2, type: SCALAR}, "             \
    "{bufferView: 0, byteOffset: 72, componentType: 5126, count: 2, type: SCALAR}, {bufferView: "  \
    "0, byteOffset: 80, componentType: 5126, count: 2, type: VEC3}]"
#define CHANNEL(node, path, sampler)                                                               \
    "{sampler: " sampler ", target: {node: " node ", path: '" path "'}}"
#define CLIP(name, channels)                                                                       \
    "{name: '" name "', channels: [" channels                                                      \
    "], samplers: [{input: 2, output: 4}, {input: 3, output: 4}]}"

static const char *write_clips(const char *clips) {
    static char more[4096];
    snprintf(more, sizeof more, "animations: [%s],", clips);
    return write_parts("clips.glb",
                       &PARTS(.accessors = ACCESSORS, .nodes = "[{mesh: 0}, {mesh: 0}, {mesh: 0}]",
                              .more = more, EXTRA(keys)));
}

static void load(struct scene *scene, const char *clips) {
    check_ok("load", scene_load(scene, write_clips(clips)));
}

static double x_of(const struct scene *scene, int node, double time) {
    float world[16];
    node_world(scene, node, time, world);
    return (double)world[12];
}

static void check_playing(const struct scene *scene, const char *expected) {
    char text[64] = "";
    for (int i = 0; i < scene->playing_count; i++)
        snprintf(text + strlen(text), sizeof text - strlen(text), "%s%d", i ? "," : "",
                 scene->playing[i]);
    assert_string_equal(text, expected);
}

#define DOOR CLIP("door", CHANNEL("0", "translation", "0"))
#define LID CLIP("lid", CHANNEL("1", "translation", "1"))
#define WALK CLIP("walk", CHANNEL("0", "translation", "0") "," CHANNEL("1", "translation", "0"))
#define RUN CLIP("run", CHANNEL("0", "translation", "1") "," CHANNEL("1", "translation", "1"))
#define BLINK CLIP("blink", CHANNEL("2", "scale", "1"))
#define GROW CLIP("grow", CHANNEL("0", "scale", "0"))

TEST(defaults) {
    static const struct {
        const char *clips, *playing;
        double duration;
    } rows[] = {
        {DOOR "," LID, "0,1", 2},
        {WALK "," RUN, "0", 1},
        {WALK "," RUN "," BLINK, "0,2", 2},
        {RUN "," WALK "," GROW, "0,2", 2},
        {DOOR "," WALK "," LID, "0,2", 2}, /* the walk would move the door as well */
        {CLIP("empty", CHANNEL("0", "other", "0")) "," DOOR, "0,1", 1},
        {CLIP("", CHANNEL("0", "translation", "0")), "0", 1},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        OWNED(scene) scene;
        load(&scene, rows[i].clips);
        check_playing(&scene, rows[i].playing);
        check_near("duration", scene_duration(&scene), rows[i].duration, 0);
        char text[CLIPS_TEXT_SIZE];
        clips_to_text(&scene, text);
        assert_string_equal(text, "");
    }
}

TEST(together) {
    OWNED(scene) scene;
    load(&scene, DOOR "," LID);
    check_near("the door at .5 s", x_of(&scene, 0, .5), 2, 1e-6);
    check_near("the lid at .5 s", x_of(&scene, 1, .5), 1, 1e-6);
    check_near("the door at 2 s", x_of(&scene, 0, 2), 4, 1e-6);
    check_near("the lid at 2 s", x_of(&scene, 1, 2), 4, 1e-6);
    OWNED(geometry) geometry;
    check_ok("geometry", geometry_init(&geometry, &scene, 0));
    check_near("bounds of both", (double)geometry.bounds_max[0], 5, 1e-6);
    check_ok("lid", clips_select(&scene, "lid"));
    check_ok("pose", geometry_pose(&geometry, &scene, 1));
    check_near("the door at rest", x_of(&scene, 0, 1), 0, 0);
    check_near("the lid", x_of(&scene, 1, 1), 2, 1e-6);
}

TEST(choice) {
    static const struct {
        const char *text, *playing, *kept;
    } rows[] = {
        {"run", "1", "1"},           {"1", "1", "1"},       {"walk,run", "0,1", "0,1"},
        {"run, walk", "1,0", "1,0"}, {"2,0", "2,0", "2,0"}, {"0,0,walk", "0", "0"},
        {"all", "0,2,3", ""},        {"", "0,2,3", ""},     {"a,b", "3", "3"},
        {"a,b,run", NULL, NULL},     {"jump", NULL, NULL},  {"walk,jump", NULL, NULL},
        {"walk,", NULL, NULL},       {"9", NULL, NULL},     {"-1", NULL, NULL},
    };
    OWNED(scene) scene;
    load(&scene, WALK "," RUN "," BLINK "," CLIP("a,b", CHANNEL("2", "translation", "0")));
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        char text[CLIPS_TEXT_SIZE];
        int before = scene.clip_choice;
        bool ok = clips_select(&scene, rows[i].text);
        assert_int_equal(ok, rows[i].playing != NULL);
        if (!ok) {
            assert_int_equal(scene.clip_choice, before);
            assert_non_null(strstr(error_get(), "0=walk 1=run 2=blink"));
            continue;
        }
        check_playing(&scene, rows[i].playing);
        clips_to_text(&scene, text);
        assert_string_equal(text, rows[i].kept);
    }
    check_ok("the last wins", clips_select(&scene, "walk,run"));
    check_near("run", x_of(&scene, 0, 1), 2, 1e-6);
    check_ok("the last wins", clips_select(&scene, "run,walk"));
    check_near("walk", x_of(&scene, 0, 1), 4, 1e-6);
}

/* A note names what is left out, info marks it, and --clip is heard. */
TEST(commands) {
    const char *path = write_clips(WALK "," RUN "," BLINK);
    expect_command(0, "info", path);
    expect_text("do not play: 1=run;");
    expect_text("channels 2, only by --clip");
    expect_command(0, "render -o @/run.exr --size 8x8 --clip run,blink --time 1", path);
    assert_null(strstr(output, "do not play"));
    expect_command(1, "render -o @/run.exr --size 8x8 --clip jump", path);
    expect_text("no clip 'jump' (there is: 0=walk 1=run 2=blink)");
}

TEST(case) {
    const char *path = shared_case("two-clips/two.gltf");
    struct scene scene;
    struct geometry geometry;
    if (!path)
        return;
    check_ok("open", scene_open(&scene, &geometry, path, NULL));
    check_playing(&scene, "0,1");
    check_ok("pose", geometry_pose(&geometry, &scene, 1));
    /* The picture is 1 m high there. */
    for (int node = 0; node < 2; node++) {
        float world[16];
        node_world(&scene, node, 1, world);
        check_at_most("out of the picture", 1.5, fabs((double)world[12]) + fabs((double)world[14]));
    }
    geometry_free(&geometry);
    scene_free(&scene);
}

RUN_TESTS(be_quiet, NULL)
