/* Models with faint lamps get the light that models without any get; lamps that make a picture are
 * left alone. Little scenes of cubes and emissive squares. */
#define _XOPEN_SOURCE 700
#include "command_support.h"
#include "cube_parts.h"

#include "scene/lights/emitter.h"
#include "scene/open.h"
#include "scene/placing.h"

/* Mesh 0 is the cube, whose triangles face outwards, mesh 1 the same inwards. */
#define ACCESSORS "[" CUBE_ACCESSORS ", " PARTS_QUAD "]"

/* Mesh 2 is a square of 1 m from the origin, towards +Z; mesh 3 is mesh 0 of the
 * square's material. */
#define MESH(positions, indices, material)                                                         \
    "{primitives: [{attributes: {POSITION: " positions "}, indices: " indices                      \
    ", material: " material "}]}"
#define MESHES                                                                                     \
    "[" MESH("0", "1", "0") "," MESH("0", "2", "0") "," MESH("3", "4", "1") "," MESH("0", "1",     \
                                                                                     "1") "]"
#define CUBE "{mesh: 0}"
#define ROOM "{mesh: 1, scale: [2.5, 1.5, 2.5]}"

/* A square of a side at a place, turned: towards +Y, -Y and +Z. */
#define UP "[-0.70710678, 0, 0, 0.70710678]"
#define DOWN "[0.70710678, 0, 0, 0.70710678]"
#define AHEAD "[0, 0, 0, 1]"
#define SQUARE(side, place, turn)                                                                  \
    "{mesh: 2, scale: [" side "," side "," side "], translation: " place ", rotation: " turn "}"
#define POINT(place) "{translation: " place ", extensions: {KHR_lights_punctual: {light: 0}}}"

static const struct row {
    const char *what, *nodes, *emission, *strength, *intensity;
    bool gets_light;
} rows[] = {
    {"a faint LED on a box", CUBE "," SQUARE("0.2", "[0, 1.01, 0]", UP), "0.05", "1", NULL, true},
    {"a strong one, which shines away", CUBE "," SQUARE("0.2", "[0, 1.01, 0]", UP), "1", "1000",
     NULL, true},
    {"two, on the front and the top",
     CUBE "," SQUARE("0.1", "[0, 1.01, 0]", UP) "," SQUARE("0.1", "[0, 0, 1.01]", AHEAD), "1", "1",
     NULL, true},
    {"a standby light in a room", ROOM "," SQUARE("0.005", "[0, 0, -2.4]", AHEAD), "0.05", "1",
     NULL, true},
    {"a lamp within a box that is shut", CUBE "," SQUARE("0.5", "[0, 0.5, 0]", DOWN), "1", "100",
     NULL, true},
    {"a lamp before a box", CUBE "," SQUARE("1", "[-0.5, 3, 1]", DOWN), "1", "20", NULL, false},
    {"a dim ceiling of a room", ROOM "," SQUARE("2", "[-1, 1.4, -1]", DOWN), "0.05", "1", NULL,
     false},
    {"a lamp that a ceiling reflects", ROOM "," SQUARE("0.5", "[-0.2, 1, 0.2]", UP), "0.5", "1",
     NULL, false},
    {"a candle in a room", ROOM "," SQUARE("0.014", "[0, 0, -1]", AHEAD), "1", "100", NULL, false},
    {"a screen in a room", ROOM "," SQUARE("0.5", "[0, 0, -2.4]", AHEAD), "0.5", "1", NULL, false},
    {"a box that emits all over", "{mesh: 3}", "0.2", "1", NULL, false},
    {"a point without power", CUBE "," POINT("[0, 3, 3]"), "0", "1", "0", true},
    {"a faint point", CUBE "," POINT("[0, 3, 3]"), "0", "1", "1e-6", false},
    {"a faint point and a faint LED",
     CUBE "," SQUARE("0.2", "[0, 1.01, 0]", UP) "," POINT("[0, 3, 3]"), "0.05", "1", "0.1", false},
    {"a sign on a box, and a lamp that brushes its front",
     CUBE
     "," SQUARE("0.6", "[-0.3, 1.02, -0.98]", AHEAD) "," SQUARE("0.2", "[-0.1, 0.8, 1.05]", DOWN),
     "1", "1", NULL, true},
    {"beacons on a box, and lamps on its front",
     CUBE "," SQUARE("0.3", "[-0.8, 1.02, -0.9]", AHEAD) "," SQUARE(
         "0.4", "[0.4, 1.02, -0.9]", AHEAD) "," SQUARE("0.1", "[-0.8, 0.9, 1.02]",
                                                       DOWN) "," SQUARE("0.1", "[0.5, 0.9, 1.02]",
                                                                        DOWN),
     "0.5", "1", NULL, true},
    {"a tube before a wall of a hall",
     ROOM "," SQUARE("0.9", "[-0.9, 0, -2.49]", AHEAD) "," SQUARE("0.05", "[1, 0, -2.3]", DOWN),
     "0.02", "1", NULL, false},
};

static const char *write_row(const struct row *row) {
    struct cube_bytes cube = make_cube();
    const char *materials =
        form("[{pbrMetallicRoughness: {metallicFactor: 0}}, {emissiveFactor: [%s, %s, %s], "
             "extensions: {KHR_materials_emissive_strength: {emissiveStrength: %s}}}]",
             row->emission, row->emission, row->emission, row->strength);
    const char *nodes = form("[%s]", row->nodes);
    const char *more =
        form("extensions: {KHR_lights_punctual: {lights: [{type: point, intensity: %s}]}},",
             row->intensity ? row->intensity : "1");
    return write_parts("row.glb",
                       &PARTS(.accessors = ACCESSORS, .materials = materials, .meshes = MESHES,
                              .nodes = nodes, .more = more, EXTRA(cube)));
}

/* How many lights there are that the file does not have. */
static int count_added(const struct scene *scene) {
    int count = 0;
    for (int i = 0; i < scene->light_count; i++)
        count += strncmp(scene->lights[i].name, "framed", 6) == 0;
    return count;
}

TEST(lamps) {
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        OWNED(scene) scene;
        OWNED(geometry) geometry;
        check_ok(rows[i].what, scene_open(&scene, &geometry, write_row(&rows[i]), NULL));
        check_near("lights added", count_added(&scene), rows[i].gets_light ? 2 : 0, 0);
    }
}

/* The decision is the same at any size of the scene, in the same light. */
TEST(far_and_large) {
    static const struct row large[] = {
        {"a LED of 20 m on a box of 200 m, far out",
         "{mesh: 0, scale: [100, 100, 100], translation: [1e6, 0, 0]},{mesh: 2, scale: [20, 20, "
         "20], translation: [1e6, 101, 0], rotation: " UP "}",
         "0.05", "1", NULL, true},
        {"a ceiling of a hangar",
         "{mesh: 1, scale: [250, 150, 250]}," SQUARE("200", "[-100, 140, -100]", DOWN), "0.05", "1",
         NULL, false}};
    for (size_t i = 0; i < sizeof large / sizeof *large; i++) {
        OWNED(scene) scene;
        OWNED(geometry) geometry;
        check_ok(large[i].what, scene_open(&scene, &geometry, write_row(&large[i]), NULL));
        check_near("lights added", count_added(&scene), large[i].gets_light ? 2 : 0, 0);
    }
}

/* A note says what was done. */
TEST(notes) {
    expect_command(0, "info", write_row(&rows[0]));
    expect_text("its own lights leave the picture dark");
    expect_command(0, "info", write_row(&rows[12]));
    expect_text("its lights are dim");
    expect_text("--set exposure=");
}

/* Metals that mirror nothing but the dark are black by lights without a size. */
TEST(mirrors) {
#define METAL(roughness) "pbrMetallicRoughness: {roughnessFactor: " roughness "}"
    static const struct {
        const char *what, *material, *nodes, *options;
        bool is_noted;
    } cases[] = {
        {"a mirror", METAL("0"), CUBE, "", true},
        {"a polished metal", METAL("0.15"), CUBE, "", true},
        {"glossiness",
         "extensions: {KHR_materials_pbrSpecularGlossiness: {diffuseFactor: [0, 0, 0, 1], "
         "specularFactor: [0.9, 0.8, 0.7], glossinessFactor: 0.95}}",
         CUBE, "", true},
        {"a brushed metal", METAL("0.3"), CUBE, "", false},
        {"gloss of what is no metal",
         "pbrMetallicRoughness: {metallicFactor: 0, roughnessFactor: 0}", CUBE, "", false},
        {"walls that mirror walls", METAL("0"), ROOM, "", false},
        {"a light of the user's", METAL("0"), CUBE, "--light '+point position=0,3,3'", false},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct cube_bytes cube = make_cube();
        const char *materials = form("[{%s}, {}]", cases[i].material);
        const char *nodes = form("[%s]", cases[i].nodes);
        const char *path =
            write_parts("metal.glb", &PARTS(.accessors = ACCESSORS, .materials = materials,
                                            .meshes = MESHES, .nodes = nodes, EXTRA(cube)));
        expect_command(0, "reference -o @/metal.exr --size 8x8 --spp 1",
                       form("%s %s", path, cases[i].options));
        bool is_noted = strstr(output, "metals mirror nothing") != NULL;
        check_near(cases[i].what, is_noted, cases[i].is_noted, 0);
    }
}

/* Nothing is added where the user names the lights, and the note tells the truth. */
TEST(named_lights) {
    static const struct {
        const char *light;
        int added, shining; /* lights */
    } texts[] = {
        {NULL, 2, 3},
        {"emitters", 0, 1},
        {"0", 0, 1},
        {"0 size=1,1", 0, 1},
        {"size=1,1", 2, 3},
        {"+point position=0,3,0", 0, 1},
        {"0; +point", 0, 2},
        {"framed spot", 2, 1},
        {"0,1", 2, 2},
        {"", 2, 3},
        {"+point; intensity=1,1,1", 2, 4},
    };
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        OWNED(scene) scene;
        OWNED(geometry) geometry;
        OWNED(emitters) emitters = {0};
        const struct scene_open_desc desc = {.light = texts[i].light};
        const char *name = texts[i].light ? texts[i].light : "no text";
        check_ok(name, scene_open(&scene, &geometry, write_row(&rows[0]), &desc));
        check_near(name, count_added(&scene), texts[i].added, 0);
        check_ok(name, emitters_from_text(&emitters, &scene, texts[i].light, 0));
        check_near("lights that shine", emitters.count, texts[i].shining, 0);
    }
}

TEST(notes_of_named_lights) {
    static const struct row without = {"a box alone", CUBE, "0", "1", NULL, true};
    static const struct {
        const struct row *row;
        const char *light;
        bool is_added;
    } cases[] = {{&rows[0], "emitters", false},
                 {&rows[0], "framed spot", true},
                 {&without, "+point position=0,3,3", false},
                 {&without, "framed spot", true}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        expect_command(0, "reference -o @/named.exr --size 16x16 --spp 1",
                       form("%s --light '%s'", write_row(cases[i].row), cases[i].light));
        bool is_noted = strstr(output, "so a spot from above") != NULL;
        check_near(cases[i].light, is_noted, cases[i].is_added, 0);
    }
}

/* A black emission map with one bright texel of 8 x 8, as a helmet's lights are: most of the model
 * is dark. */
TEST(emission_map) {
    static const char *const maps[] = {"iVBORw0KGgoAAAANSUhEUgAAAAgAAAAICAAAAADhZOFXAAAAD0lEQVR42mN"
                                       "gwA7+M5AGADAYAQAynfmjAAAAAElFTkSuQmCC"
                                       /* one texel of 255 */,
                                       "iVBORw0KGgoAAAANSUhEUgAAAAgAAAAICAAAAADhZOFXAAAADklEQVR42mN"
                                       "ogAIGyhgAgIQgARDoahcAAAAASUVORK5CYII="
                                       /* all of 128 */};
    static const float uv[8] = {0, 0, 1, 0, 1, 1, 0, 1};
    for (int i = 0; i < 2; i++) {
        OWNED(scene) scene;
        OWNED(geometry) geometry;
        const char *more =
            form("images: [{uri: 'data:image/png;base64,%s'}],textures: [{source: 0}],", maps[i]);
        const char *path = write_parts(
            "map.glb",
            &PARTS(.accessors = PARTS_TEXTURED,
                   .materials = "[{emissiveTexture: {index: 0}, emissiveFactor: [1, 1, 1]}]",
                   .meshes = "[{primitives: [{attributes: {POSITION: 0, TEXCOORD_0: 2}, indices: "
                             "1, material: 0}]}]",
                   .more = more, EXTRA(uv)));
        check_ok("open", scene_open(&scene, &geometry, path, NULL));
        check_near("lights added", count_added(&scene), i ? 0 : 2, 0);
    }
}

/* The case of the public reports. */
TEST(case) {
    const char *path = shared_case("faint-emission/led.gltf");
    struct scene scene;
    struct geometry geometry;
    if (!path)
        return;
    check_ok("open", scene_open(&scene, &geometry, path, NULL));
    check_near("lights added", count_added(&scene), 2, 0);
    geometry_free(&geometry);
    scene_free(&scene);
}

RUN_TESTS(be_quiet, NULL)
