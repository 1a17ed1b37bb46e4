/* manylight info. */
#include "command_support.h"
#include "gltf_parts.h"

#define EYE(more)                                                                                  \
    "{\"type\": \"perspective\", \"perspective\": {\"yfov\": 1, \"znear\": 1" more "}}"

TEST(gl) {
    if (run_line("% info") != 0) {
        printf("    skipped: %s\n", output);
        skip();
    }
    expect_text("context   ");
    expect_text("renderer  ");
    expect_text("uniform block bytes");
}

TEST(scene) {
    expect_command(0, "info", "scenes/cornell-box.glb");
    expect_text("72 vertices, 36 triangles (36 without alpha mask)");
    expect_text("(-2.78, 0, -2.796) to (2.78, 5.488, 2.796) m");
    expect_text(
        "  0  white                base colour (0.725, 0.71, 0.68), metalness 0, roughness 1");
    expect_text("lights     1\n");
    expect_text("spot (500, 500, 500) W/sr at (1.1, 2.3, 1.9)");
    expect_text("cameras    1\n");
    expect_text("perspective, 39.31 degrees high, at (0, 2.73, 10.8) towards (0, 0, -1)");
    assert_null(strstr(output, "renderer"));
}

/* Glass, the medium and the slide of a spot. */
TEST(glass_and_slide) {
    expect_command(0, "info", "scenes/window.glb");
    expect_text("roughness 0, transmission 1, index of refraction 1.5, thin\n");
    expect_text("medium     scatters (0.05, 0.05, 0.05), absorbs (0.002, 0.002, 0.002) 1/m, g 0.4");
    expect_command(0, "info", "scenes/gem.glb");
    expect_text("transmission 1, index of refraction ");
    need_command("python3 -c 1");
    expect(
        0,
        "python3 test/apps/add_slide.py scenes/cornell-box.glb @/slide.glb && % info @/slide.glb");
    expect_text("cone 28.71 to 29 degrees, slide of 1 x 1 texels\n");
}

TEST(point_light) {
    expect_command(0, "info", "scenes/sphere.glb");
    expect_text("point (3.142, 3.142, 3.142) W/sr at (0, 0, 0)\n");
}

/* Names are those of nodes, as in messages; of what a node without a name carries. */
TEST(names) {
    const char *path =
        write_parts("names.glb",
                    &PARTS(.nodes = "[{mesh: 0}, {name: 'Eye node', camera: 0}, {camera: 0}, "
                                    "{name: 'Lamp node', extensions: {KHR_lights_punctual: {light: "
                                    "0}}}, {extensions: {KHR_lights_punctual: {light: 0}}}]",
                           .more = "cameras: [{name: 'Eye data', type: perspective, perspective: "
                                   "{yfov: 1, znear: 1}}], extensions: {KHR_lights_punctual: "
                                   "{lights: [{name: 'Lamp data', type: point}]}},"));
    expect_command(0, "info", path);
    expect_text("  0  Eye node             perspective");
    expect_text("  1  Eye data             perspective");
    expect_text("  0  Lamp node            point");
    expect_text("  1  Lamp data            point");
    expect_command(1, "reference -o @/none.exr --camera none", path);
    expect_text("(there is: 0=Eye node 1=Eye data)");
    expect_command(1, "reference -o @/none.exr --light none", path);
    expect_text("(there is: 0=Lamp node 1=Lamp data)");
}

/* Without --size a picture has the aspect ratio of its camera. */
TEST(aspect) {
    static const struct {
        const char *camera, *size, *says;
    } rows[] = {
        {"--camera 0", "800x800", "57.3 degrees high, at"},
        {"--camera 1", "800x50", "57.3 degrees high, aspect ratio 16, at"},
        {"--camera 2", "80x800", "57.3 degrees high, aspect ratio 0.1, at"},
        {"--camera 3", "800x100", "2 m high, aspect ratio 8, at"},
        {"--camera '1 eye=0,0,3'", "800x50", ""},
        {"--camera 1 --size 16x8", "16x8", ""},
    };
    const char *path = form(
        "%s",
        write_parts("aspect.glb",
                    &PARTS(.nodes = "[{mesh: 0}, {camera: 0}, {camera: 1}, {camera: 2}, "
                                    "{camera: 3}, {camera: 4}, {camera: 5}]",
                           .more = "cameras: [" EYE("") "," EYE(", \"aspectRatio\": 16") "," EYE(
                               ", \"aspectRatio\": 0.1") ",{type: orthographic, "
                                                         "orthographic: {xmag: -8, "
                                                         "ymag: 1, znear: 0, zfar: "
                                                         "9}}," EYE(", \"aspectRatio\": "
                                                                    "0") "," EYE(", "
                                                                                 "\"aspe"
                                                                                 "ctRati"
                                                                                 "o\": "
                                                                                 "1e9") "],")));
    expect_command(0, "info", path);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        expect_text(rows[i].says);
    expect_text("  4                       perspective, 57.3 degrees high, at");
    expect_text("  5                       perspective, 57.3 degrees high, at");
    for (size_t i = 0; i < 2 * sizeof rows / sizeof *rows; i++) {
        int pixels[2];
        expect_command(0, i % 2 ? "reference --spp 1" : "render --set vpls=16,vals=2,interleave=1",
                       form("%s -q -o @/aspect.exr %s", path, rows[i / 2].camera));
        check_ok("aspect.exr", image_size(scratch("aspect.exr"), pixels));
        const char *size = form("%dx%d", pixels[0], pixels[1]);
        printf("    %-9s %-24s %s\n", i % 2 ? "reference" : "render", rows[i / 2].camera, size);
        assert_string_equal(size, rows[i / 2].size);
    }
}

#define SAME(of)                                                                                   \
    "% info " of " >@/text && % info --json " of                                                   \
    " >@/json && python3 test/apps/check_info.py @/text @/json"

/* As JSON the same facts, whatever names have in them; nothing where a part fails. */
TEST(json) {
    need_command("python3 -c 'import json'");
    expect(0, SAME("scenes/window.glb"));
    expect(0, SAME("scenes/creatures.glb"));
    expect(0, SAME("scenes/gem.glb"));
    expect(0, SAME("scenes/table.glb"));
    write_parts("hostile.glb",
                &PARTS(.nodes = "[{mesh: 0}, {name: \"a\\\"}], "
                                "\\\\\\n\\u0001\\u00e4\\ud83d\\ude00%s\", camera: 0}]",
                       .more = "cameras: [" EYE(", \"zfar\": 9.5") "],"));
    expect(0, SAME("@/hostile.glb"));
    expect(0, "grep -F 'a\\\"}], \\\\' @/json");
    expect(1, "% info --json @/no-such-scene.glb 2>&1 >@/json; r=$?; test ! -s @/json && exit $r");
    if (run_line("% info") == 0)
        expect(0, SAME("scenes/ring.glb --gl"));
}

TEST(refusals) {
    expect_command(1, "info", "no-such-scene.glb");
    assert_string_equal(
        output, "manylight info: cannot open no-such-scene.glb: No such file or directory\n");
    expect_command(2, "info", "one.glb two.glb");
    expect_command(2, "info", "--context glx");
    expect_text("one of auto, egl, osmesa");
    expect_command(1, "info", "--context osmesa --device 0");
    expect_text("no EGL device 0 (there are 0, counted from 0)");
}

RUN_TESTS(NULL, NULL)
