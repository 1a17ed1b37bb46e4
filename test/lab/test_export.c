/* manylight export: what other renderers would read is the scene, by readers of the test's own. */
#include "base/unit.h"
#include "command_support.h"

#include "renderer/stage.h"

static int clean(void **state) {
    (void)state;
    scratch("");
    expect(0, "rm -rf @/*");
    return 0;
}

TEST(formats_are_the_scene) {
    static const char *const scenes[] = {"cornell-box", "three-lights", "table", "courtyard",
                                         "plant"};
    static const char *const formats[] = {"pack", "mitsuba"};
    need_command("python3 -c 1");
    for (size_t s = 0; s < sizeof scenes / sizeof *scenes; s++)
        for (size_t f = 0; f < sizeof formats / sizeof *formats; f++) {
            expect(0,
                   form("%% export scenes/%s.glb -o @/out --format %s --size 300x200 -q &&"
                        " python3 test/apps/check_export.py %s @/out scenes/%s.glb && rm -r @/out",
                        scenes[s], formats[f], formats[f], scenes[s]));
        }
}

TEST(schema) {
    need_command("python3 -c 'import jsonschema'");
    expect(0, "for s in three-lights courtyard table; do"
              " % export scenes/$s.glb -o @/schema-$s -q || exit 1; done");
    expect(0, "% export scenes/three-lights.glb -o @/schema-all -q --environment scenes/day.hdr"
              " --light '0 size=1,0; 1 range=3; sky; +area size=1,2; +directional size=0.1,0'");
    expect(0, "for s in three-lights courtyard table all; do python3 test/apps/check_schema.py"
              " bench/schema/pack.schema.json @/schema-$s/scene.json || exit 1; done");
    expect(1, "sed 's/\"bounces\": 1/\"bounces\": -1/' @/schema-all/scene.json > @/wrong.json;"
              " python3 test/apps/check_schema.py bench/schema/pack.schema.json @/wrong.json");
}

/* The shorter side of a high picture is its width. */
TEST(high_picture) {
    need_command("python3 -c 1");
    expect(0, "% export scenes/cornell-box.glb -o @/high --format mitsuba --size 100x200 -q &&"
              " python3 test/apps/check_export.py mitsuba @/high scenes/cornell-box.glb");
}

/* A checker that misses a change would pass anything. */
TEST(checker_sees_changes) {
    static const char *const changes[] = {"s/up=.0 1 0/up=\"0 -1 0/",
                                          "s/intensity. value=.500/intensity\" value=\"501/",
                                          "s/fov. value=.39/fov\" value=\"38/",
                                          "s/0.0649999976/0.066/",
                                          "s/angle. value=.28.9/angle\" value=\"29.3/",
                                          "s/max_depth/max_depth/"};
    need_command("python3 -c 1");
    expect(0, "% export scenes/cornell-box.glb -o @/seen --format mitsuba -q");
    for (size_t i = 0; i < sizeof changes / sizeof *changes; i++) {
        bool is_last = i + 1 == sizeof changes / sizeof *changes;
        const char *line =
            form("rm -rf @/changed; cp -r @/seen @/changed && sed -i '%s' @/changed/scene.xml &&"
                 " python3 test/apps/check_export.py mitsuba @/changed scenes/cornell-box.glb",
                 changes[i]);
        expect(is_last ? 0 : 1, line);
    }
}

/* --- environment ------------------------------------------------------------------------------ */

static float random_float(uint32_t *state) {
    *state = *state * 1664525 + 1013904223;
    return (float)(*state >> 8) / 16777216;
}

static void random_direction(uint32_t *state, float direction[3]) {
    float z = 2 * random_float(state) - 1, turn = 6.2831853F * random_float(state);
    float across = sqrtf(1 - z * z);
    glm_vec3_copy((vec3){across * cosf(turn), across * sinf(turn), z}, direction);
}

/* Where Mitsuba looks a direction up, its panorama turned about +Y by that many degrees. */
static void mitsuba_texel(const struct image *image, const float d[3], float turn,
                          const float **texel) {
    float a = turn * GLM_PIf / 180;
    float x = cosf(a) * d[0] - sinf(a) * d[2], z = sinf(a) * d[0] + cosf(a) * d[2];
    float u = atan2f(x, -z) / (2 * GLM_PIf), v = acosf(d[1]) / GLM_PIf;
    u -= floorf(u);
    int column = (int)(u * (float)image->width), row = (int)(v * (float)image->height);
    *texel = image_at(image, column < image->width ? column : image->width - 1,
                      row < image->height ? row : image->height - 1);
}

/* The share of directions in which the file has what the scene has. */
static double share_of_same(const struct environment *sky, const struct image *image, float turn,
                            float strength) {
    uint32_t state = 1;
    int same = 0;
    enum { DIRECTIONS = 20000 };
    for (int i = 0; i < DIRECTIONS; i++) {
        float direction[3], radiance[3];
        const float *texel;
        random_direction(&state, direction);
        environment_radiance(sky, direction, radiance);
        mitsuba_texel(image, direction, turn, &texel);
        same += fabsf(strength * texel[1] - radiance[1]) < .002F * radiance[1];
    }
    return (double)same / DIRECTIONS;
}

TEST(environment_lies_right) {
    OWNED(stage) stage;
    struct image image;
    float angle = 0, scale = 0;
    const struct stage_desc desc = {.path = "scenes/courtyard.glb",
                                    .environment = {.turn = 70, .strength = 3}};
    check_ok("stage", stage_init(&stage, &desc));
    expect(0, "% export scenes/courtyard.glb -o @/sky-mitsuba --format mitsuba -q"
              " --environment-turn 70 --environment-strength 3 &&"
              " grep -o 'angle=\"[0-9.]*' @/sky-mitsuba/scene.xml | tr -d 'a-z=\"' &&"
              " grep -o 'scale\" value=\"[0-9.]*' @/sky-mitsuba/scene.xml | tr -d 'a-z=\" '");
    assert_int_equal(sscanf(output, "%f %f", &angle, &scale), 2);
    check_ok("panorama", image_read(&image, scratch("sky-mitsuba/environment.exr")));
    double share = share_of_same(stage.emitters.sky, &image, angle, scale);
    image_free(&image);
    printf("    Mitsuba: %.3f of the directions\n", share);
    assert_true(share > .99);
}

/* --- what formats lack ------------------------------------------------------------------------ */

TEST(notes_are_in_the_files) {
    expect(0, "% export scenes/gloss.glb -o @/gloss --format mitsuba");
    expect_text("Mitsuba's principled BSDF in place of glTF's");
    expect(0, "grep -c '<!-- material .*principled' @/gloss/scene.xml");
    expect(0, "% export scenes/gloss.glb -o @/plain --format mitsuba --materials diffuse");
    assert_null(strstr(output, "principled"));
    expect(0, "% export scenes/materials.glb -o @/textured --format mitsuba");
    expect_text("its alpha mask is not interpolated");
    expect(0, "ls @/textured/color-*.exr @/textured/mask-*.png");
    expect(0, "% export scenes/hall.glb -o @/hall --format mitsuba");
    expect_text("the medium is left out");
}

/* No format has slides. */
TEST(slide_is_noted) {
    need_command("python3 -c 1");
    expect(0, "python3 test/apps/add_slide.py scenes/cornell-box.glb @/slide.glb");
    for (int i = 0; i < 2; i++) {
        expect(0, i ? "% export @/slide.glb -o @/slide-pack"
                    : "% export @/slide.glb -o @/slide-mitsuba --format mitsuba");
        assert_int_equal(count_text(output, "light 0: its slide is left out"), 1);
    }
}

/* All XML is well-formed, and all files that it names are there. */
TEST(xml_is_well_formed) {
    need_command("python3 -c 1");
    expect(0,
           "for scene in gloss textured; do python3 -c 'import sys, os, xml.etree.ElementTree as"
           " e\nfor f in e.parse(sys.argv[1]).getroot().iter(\"string\"):\n if f.get(\"name\") =="
           " \"filename\": os.stat(os.path.dirname(sys.argv[1]) + \"/\" + f.get(\"value\"))'"
           " @/$scene/scene.xml || exit 1; done");
}

/* Names of materials may have what ends a comment. */
TEST(odd_names) {
    need_command("python3 -c 1");
    expect(0, "LC_ALL=C sed 's/\"name\":\"metal/\"name\":\"-->--/' scenes/gloss.glb > @/odd.glb &&"
              " % export @/odd.glb -o @/odd --format mitsuba && grep -e '- ->' @/odd/scene.xml &&"
              " python3 -c 'import xml.etree.ElementTree as e\ne.parse(\"@/odd/scene.xml\")'");
}

/* A name that begins with dots has a name without them. */
TEST(dots) {
    expect(0, "cp scenes/cornell-box.glb @/..glb && % export @/..glb -o @/dots --size 9x8 -q &&"
              " grep -e '\"name\": ' -e '\"file\": ' @/dots/scene.json");
    expect_text("\"name\": \"glb\"");
    expect_text("\"file\": \"glb.9x8.exr\"");
}

/* Formats have one mode for both directions. Texture 4 is repeated across and mirrored down,
 * outside of 0 to 1; texture 6 is changed to be mirrored in one direction, which its coordinates
 * never leave. */
TEST(wrap_modes) {
    expect(0, "% export scenes/materials.glb -o @/wrap --format mitsuba 2>&1 | grep wraps");
    assert_int_equal(count_text(output, "note: texture 4: wraps down as it does across"), 1);
    for (int down = 0; down < 2; down++) {
        expect(0,
               down ? "sed 's/\"wrapS\":33071,\"wrapT\":33071}]/\"wrapS\":33071,\"wrapT\":33648}]/'"
                      " scenes/materials.glb > @/one.glb"
                    : "sed 's/\"wrapS\":33071,\"wrapT\":33071}]/\"wrapS\":33648,\"wrapT\":33071}]/'"
                      " scenes/materials.glb > @/one.glb");
        expect(1, "cmp -s @/one.glb scenes/materials.glb");
        expect(0, "rm -rf @/one; % export @/one.glb -o @/one --format mitsuba 2>&1 | grep wraps;"
                  " grep -A2 'color-7.exr' @/one/scene.xml");
        assert_int_equal(count_text(output, "wraps"), 1);
        expect_text(down ? "\"clamp\"" : "\"mirror\"");
    }
}

/* A signal while files are written leaves none of them. */
TEST(interrupted) {
    expect(143, "% export scenes/courtyard.glb -o @/ended --format mitsuba & p=$!; until"
                " ls -d @/ended.part-* || ! kill -0 $p; do :; done > @/log.txt 2>&1; kill -TERM $p;"
                " wait $p");
    expect(2, "ls -d @/ended @/ended.part-*");
}

/* A light that is changed, and a lamp that is left off. */
TEST(chosen_lights) {
    expect(0, "% export scenes/table.glb -o @/dark --format mitsuba -q --light \"+point"
              " position=0,2,0 intensity=1,2,3\" && grep -A3 'type=\"point\"' @/dark/scene.xml");
    expect_text("value=\"0 2 0\"");
    expect_text("value=\"1 2 3\"");
    expect(1, "grep 'type=\"area\"' @/dark/scene.xml");
    expect(0, "% export scenes/table.glb -o @/dark-pack -q --light \"+point position=0,2,0\" &&"
              " grep emissive_surfaces @/dark-pack/scene.json");
    expect_text("false");
    expect(0, "% export scenes/table.glb -o @/sized --format mitsuba -q --light \"+area position="
              "0,2,0 direction=0,-1,0 size=1,2 intensity=4,4,4\"");
    expect(0, "grep 'radiance\" value=\"2 2 2\"' @/sized/scene.xml");
}

/* --- entries ---------------------------------------------------------------------------------- */

/* Draws a small picture of the box by a script of bench/entries/, and compares it. */
static void check_entry(const char *command, const char *pack, double most_bias,
                        double most_error) {
    double error = NAN, bias = NAN;
    expect(0, "mkdir -p @/references; ls @/references/*.exr || % reference scenes/cornell-box.glb"
              " --size 48x48 --spp 256 -q -o @/references/cornell-box.48x48.exr");
    const char *line =
        form("rm -rf @/%s @/entry; %% export scenes/cornell-box.glb -o @/%s --size 48x48 -q && %s >"
             " @/log.txt 2>&1 || { tail -5 @/log.txt; exit 1; }",
             pack, pack, command);
    expect(0, line);
    expect(0,
           "% compare @/entry/*.exr @/references/*.exr --json -m relative-rmse -m relative-bias");
    const char *metrics = strstr(output, "\"metrics\"");
    assert_non_null(metrics);
    assert_int_equal(sscanf(metrics, "\"metrics\": {\"relative-rmse\": %lf, \"relative-bias\": %lf",
                            &error, &bias),
                     2);
    check_near("bias", bias, 0, most_bias);
    check_at_most("relative RMSE", error, most_error);
}

TEST(cycles) {
    need_command("blender --version");
    check_entry("blender -b --factory-startup -P bench/entries/blender/entry.py -- @/entry @/cycles"
                " --spp 64",
                "cycles", .02, .2);
}

TEST(povray) {
    need_command("povray --version");
    check_entry("python3 bench/entries/povray/entry.py @/entry @/povray", "povray", .02, .2);
}

/* Scripts refuse what they cannot draw before they start anything. */
TEST(scripts_refuse) {
    need_command("python3 -c 1");
    expect(0, "rm -rf @/lamp; % export scenes/courtyard.glb -o @/lamp -q");
    expect(1, "python3 bench/entries/povray/entry.py @/refused @/lamp");
    expect_text("an environment; this script draws points, spots and emissive surfaces alone");
    expect(1, "python3 bench/entries/povray/entry.py @/refused @/nowhere");
    expect_text("no scene pack");
    expect(1, "rm -rf @/far; % export scenes/cornell-box.glb -o @/far --size 8x8 -q &&"
              " sed -i 's|\"cornell-box.8x8|\"../cornell-box.8x8|' @/far/scene.json &&"
              " python3 bench/entries/povray/entry.py @/refused @/far");
    expect_text("picture.file is no plain name");
}

TEST(refusals) {
    expect(2, "% export scenes/table.glb");
    expect_text("-o FOLDER is missing");
    expect(2, "% export scenes/table.glb -o @/none --format maya");
    expect(1, "% export no-such.glb -o @/none");
    expect(1, "% export scenes/table.glb -o @/none --camera nobody");
    expect(1, "mkdir -p @/there && % export scenes/table.glb -o @/there");
    expect_text("exists: choose the name of a new folder");
    expect(1, "% export scenes/table.glb -o @/no/such/folder");
    expect_text("cannot make the folder");
    expect(1, "printf '{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{}]}' > @/e.gltf;"
              " % export @/e.gltf -o @/none");
    expect(1, "% export scenes/materials.glb -o @/none --light 0,1");
    expect_text("emissive surfaces shine all or none");
    expect(2, "ls -d @/none @/none.part-* @/no @/no.part-* @/there.part-* 2>/dev/null");
}

RUN_TESTS(clean, NULL)
