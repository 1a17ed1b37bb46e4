/* How files come into the viewer, by real input events: a sky is dropped, turned and removed, and
 * what cannot be opened leaves a window that goes on. */
#define _XOPEN_SOURCE 700
#include "view_stage.h"

#include "gltf_parts.h"

#define BOX "scenes/cornell-box.glb"
#define SPHERE "scenes/sphere.glb"

static bool log_has(const char *text) {
    for (int i = 0; i < 100; i++) {
        if (shell(": search; grep -q -- '%s' %s/viewer.log", text, stage.folder) == 0)
            return true;
        pause_ms(50);
    }
    return false;
}

static void check_setting(const char *key, const char *expected) {
    char value[600];
    read_setting(key, value, sizeof value);
    printf("    %s = %s\n", key, value);
    assert_string_equal(value, expected);
}

static void copy(const char *from, const char *name) {
    assert_int_equal(
        shell("mkdir -p %s/sub && cp %s/%s %s", stage.folder, stage.here, from, in_stage(name)), 0);
}

/* A file that another program writes anew is shown, from where the user stood; one that cannot be
 * read leaves the scene, and is not tried for ever. */
TEST(changed_file) {
    char before[600];
    copy(BOX, "changed.glb");
    start_viewer(SPHERE, "--verbose");
    drop(in_stage("changed.glb"));
    wait_for_scene("changed.glb");
    xdo("keydown w sleep .3 keyup w");
    save_settings();
    read_setting("camera", before, sizeof before);
    assert_string_not_equal(before, "0");
    copy(SPHERE, "changed.glb");
    assert_true(log_has("changed.glb has changed"));
    save_settings();
    check_setting("camera", before);
    write_in_stage("changed.glb", "no scene");
    assert_true(log_has("changed.glb: "));
    copy(BOX, "changed.glb");
    save_settings();
    check_setting("camera", before);
    end_viewer();
}

/* --- what cannot be opened -------------------------------------------------------------------- */

/* A file that is not there, a folder and a broken file: the start page, and the reason on stderr */
TEST(start_page) {
    static const char *const names[] = {"nosuch.glb", "sub", "broken.glb"};
    assert_int_equal(shell("mkdir -p %s/sub", stage.folder), 0);
    write_in_stage("broken.glb", "glTF and then nothing");
    for (int i = 0; i < 3; i++) {
        const char *arguments = form("%s --size %dx%d", names[i], WIDTH, HEIGHT);
        start_empty_viewer(arguments);
        assert_true(log_has(names[i]));
        printf("    %s: the start page\n", names[i]);
        if (i < 2)
            end_viewer();
    }
    open_by_panel(BOX);
    wait_for_scene("cornell-box.glb");
    end_viewer();
    assert_int_equal(shell(": search; cd %s && %s view nosuch.glb --frames 1 >script.log 2>&1",
                           stage.folder, stage.binary),
                     1);
    assert_int_equal(shell("test $(grep -c nosuch.glb %s) = 1", in_stage("script.log")), 0);
}

/* --- a sky ------------------------------------------------------------------------------------ */

#define SKY "--environment scenes/overcast.hdr"

TEST(sky_dropped) {
    start_viewer("scenes/three-lights.glb", "");
    drop("scenes/overcast.hdr");
    check_same("a sky that was dropped", "scenes/three-lights.glb " SKY);
    xdo("key ctrl+z");
    check_same("and taken back", "scenes/three-lights.glb");
    xdo("key ctrl+y");
    check_same("and again", "scenes/three-lights.glb " SKY);
}

TEST(sky_turned) {
    need_viewer();
    press("Light");
    type_into("turn, \xc2\xb0", "90");
    check_same("turned", "scenes/three-lights.glb " SKY " --environment-turn 90");
    type_into("strength", "2.5");
    check_same("stronger",
               "scenes/three-lights.glb " SKY " --environment-turn 90 --environment-strength 2.5");
    press("sky shines");
    rest_mouse();
    check_same("off", "scenes/three-lights.glb --light 0,1,2");
    press("sky shines");
    save_settings();
    check_setting("environment-turn", "90");
    check_setting("environment-strength", "2.5");
    press("Remove the sky");
    rest_mouse();
    check_same("removed", "scenes/three-lights.glb");
    press("Load");
    rest_mouse();
    check_same("settings bring it back",
               "scenes/three-lights.glb " SKY " --environment-turn 90 --environment-strength 2.5");
}

static void empty_sky_field(void) {
    int x, y;
    find_place("sky", &x, &y);
    click(x, y);
    sync_viewer();
    xdo("key ctrl+a key BackSpace key Return");
    rest_mouse();
    sync_viewer();
}

/* Lights that stand in for missing ones go, as they do with --environment, and come again when the
 * sky is removed; the copied line says it all. */
TEST(sky_of_unlit_scene) {
    need_viewer();
    const char *unlit = form("%s", write_parts("unlit.glb", &PARTS(.asset = NULL)));
    const char *under_sky = form("%s --environment scenes/day.hdr", unlit);
    drop(unlit);
    wait_for_scene("unlit.glb");
    drop("scenes/day.hdr");
    check_same("a sky where no light was", under_sky);
    const char *command = copy_command();
    assert_non_null(strstr(command, "/scenes/day.hdr"));
    assert_non_null(strstr(command, "--light sky "));
    xdo("key ctrl+z");
    check_same("and taken back", unlit);
    xdo("key ctrl+y");
    check_same("and again", under_sky);
    press("Remove the sky");
    rest_mouse();
    check_same("removed: the lights that stood in shine again", unlit);
    xdo("key ctrl+z");
    check_same("taken back", under_sky);
    empty_sky_field();
    check_same("removed by its field", unlit);
    end_viewer();
}

/* The casters of its renderer are those of time 0, as offscreen. */
TEST(sky_of_moving_scene) {
    start_viewer("scenes/metaballs.glb", "--time 1.5");
    check_same("without a sky", "scenes/metaballs.glb --time 1.5");
    drop("scenes/overcast.hdr");
    check_same("with a sky", "scenes/metaballs.glb --time 1.5 " SKY);
    end_viewer();
}

/* A grey picture of that size. */
static const char *write_picture(const char *name, const char *channels, int width, int height) {
    OWNED(image) image;
    const char *path = in_stage(name);
    image_init(&image, width, height, channels);
    for (int i = 0; i < width * height * image.channel_count; i++)
        image.pixels[i] = .5F;
    check_ok(name, image_write(&image, path));
    return path;
}

static void check_sky(const char *name, bool is_sky) {
    char value[600];
    save_settings();
    read_setting("environment", value, sizeof value);
    OWNED(bitmap) shown = screenshot();
    const char *slash = strrchr(value, '/');
    printf("    %-12s environment %s, the picture %d x %d\n", name, slash ? slash + 1 : value,
           shown.width, shown.height);
    assert_true(is_sky == (strstr(value, name) != NULL));
    assert_true(is_sky == (shown.width == WIDTH && shown.height == HEIGHT));
}

/* A picture is a reference where it has layers or depth, or is no panorama; else it is a sky. */
TEST(pictures) {
    static const struct {
        const char *name, *channels;
        int width, height;
        bool is_sky;
    } pictures[] = {
        {"plain.exr", "R G B", 64, 32, true},
        {"layers.exr", "R G B direct.R direct.G direct.B", 64, 32, false},
        {"alpha.exr", "R G B A", 16, 8, true},
        {"depth.exr", "R G B Z", 64, 32, false},
        {"sky.HDR", "R G B", 32, 16, true},
        {"square.exr", "R G B", 40, 40, false},
    };
    for (size_t i = 0; i < sizeof pictures / sizeof *pictures; i++) {
        start_viewer(BOX, "");
        drop(write_picture(pictures[i].name, pictures[i].channels, pictures[i].width,
                           pictures[i].height));
        check_sky(pictures[i].name, pictures[i].is_sky);
        end_viewer();
    }
}

/* --- a slide ---------------------------------------------------------------------------------- */

/* Scenes with a slide and without, one after the other. */
TEST(slide_and_none) {
    if (shell("python3 test/apps/add_slide.py %s %s", BOX, in_stage("slide.glb")) != 0) {
        printf("    skipped: no python3\n");
        skip();
    }
    start_viewer(BOX, "");
    for (int i = 0; i < 2; i++) {
        drop(in_stage("slide.glb"));
        wait_for_scene("slide.glb");
        check_same("a scene with a slide", in_stage("slide.glb"));
        drop(BOX);
        wait_for_scene("cornell-box.glb");
        check_same("and one without", BOX);
    }
    end_viewer();
}

RUN_TESTS(open_view_stage, close_view_stage)
