/* Which parts of a file are shown: nodes below a scene's list, nodes that are hidden, the chosen scene and variant. */
#include "gltf_parts.h"

#include "base/error.h"
#include "base/log.h"
#include "scene/camera.h"
#include "scene/lights/emitter.h"
#include "scene/open.h"

struct opened {
    struct scene scene;
    struct geometry geometry;
};

static bool open_parts(struct opened *opened, const struct gltf_parts *parts,
                       struct scene_choice choice) {
    hear_notes();
    bool ok = scene_open(&opened->scene, &opened->geometry, write_parts("shown.glb", parts),
                         &(struct scene_open_desc){.choice = choice, .may_be_empty = true});
    end_notes();
    return ok;
}

static void close_parts(struct opened *opened) {
    geometry_free(&opened->geometry);
    scene_free(&opened->scene);
}

/* So many quads, the first at a height; the note is there, or none is. */
static void check_drawn(const char *what, const char *nodes, const char *more, unsigned quads,
                        double z, const char *note) {
    struct opened opened;
    check_ok(what, open_parts(&opened, &(struct gltf_parts){.nodes = nodes, .more = more},
                              (struct scene_choice){0}));
    check_near(what, opened.geometry.index_count / 6., quads, 0);
    if (quads > 0)
        check_near(what, (double)opened.geometry.position[0][2], z, 0);
    if (*note ? !strstr(notes, note) : strstr(notes, "drawn once") != NULL)
        fail_msg("%s: not the note '%s':\n%s", what, note, notes);
    close_parts(&opened);
}

/* --- the tree --------------------------------------------------------------------------------- */

#define LIFTED "{\"translation\": [0, 0, 1], \"mesh\": 0}"
#define ABOVE(children) "{\"translation\": [0, 0, 7], \"children\": [" children "]}"
#define LISTED(nodes) "\"scenes\": [{\"nodes\": [" nodes "]}],"
#define ONCE "listed twice, or as roots below a parent, are drawn once, below it: node "

static void test_lists(void **state) {
    (void)state;
    check_drawn("as it should be", "[" ABOVE("1") ", " LIFTED "]", LISTED("0"), 1, 8, "");
    check_drawn("a parent outside", "[" ABOVE("1") ", " LIFTED "]", LISTED("1"), 1, 1, ONCE "1");
    check_drawn("a parent inside", "[" ABOVE("1") ", " LIFTED "]", LISTED("0, 1"), 1, 8, ONCE "1");
    check_drawn("before it", "[" ABOVE("1") ", " LIFTED "]", LISTED("1, 0"), 1, 8, ONCE "1");
    check_drawn("a grandchild", "[" ABOVE("1") ", {\"children\": [2]}, " LIFTED "]", LISTED("2, 0"),
                1, 8, ONCE "2");
    check_drawn("twice a root", "[" LIFTED "]", LISTED("0, 0"), 1, 1, ONCE "0");
    check_drawn("twice a child", "[" ABOVE("1, 1") ", " LIFTED "]", LISTED("0"), 1, 8, ONCE "1");
    check_drawn("two parents, one outside", "[" ABOVE("2") ", " ABOVE("2") ", " LIFTED "]",
                LISTED("1"), 1, 8, "");
    check_drawn("a loop outside", "[" ABOVE("1") ", " ABOVE("0") ", " LIFTED "]", LISTED("2"), 1, 1,
                "");
    struct opened opened;
    check_refused(open_parts(&opened,
                             &(struct gltf_parts){.nodes = "[" ABOVE("1") ", " ABOVE("0") "]",
                                                  .more = LISTED("1")},
                             (struct scene_choice){0}),
                  "node 1: it is its own ancestor");
}

/* --- visibility ------------------------------------------------------------------------------- */

#define VISIBLE(flag) "\"extensions\": {\"KHR_node_visibility\": {\"visible\": " flag "}}"
#define REQUIRED "\"extensionsRequired\": [\"KHR_node_visibility\"],"

static void test_hidden(void **state) {
    (void)state;
    check_drawn("hidden", "[{\"mesh\": 0, " VISIBLE("false") "}, " LIFTED "]", REQUIRED, 1, 1, "");
    check_drawn("shown", "[{\"mesh\": 0, " VISIBLE("true") "}]", REQUIRED, 1, 0, "");
    check_drawn("by default", "[{\"mesh\": 0, \"extensions\": {\"KHR_node_visibility\": {}}}]", "",
                1, 0, "");
    check_drawn("below",
                "[{\"children\": [1], " VISIBLE("false") "}, {\"children\": [2], " VISIBLE(
                    "true") "}, {\"mesh\": 0}]",
                "", 0, 0, "");
    check_drawn("beside",
                "[{\"children\": [1, 2]}, {\"mesh\": 0, " VISIBLE("false") "}, " LIFTED "]", "", 1,
                1, "");
    check_drawn("instances",
                "[{\"mesh\": 0, \"extensions\": {\"KHR_node_visibility\": {\"visible\": false},"
                " \"EXT_mesh_gpu_instancing\": {\"attributes\": {\"TRANSLATION\": 0}}}}]",
                "", 0, 0, "");
}

/* A lamp, an emissive quad and a camera: only the camera stays. */
static void test_hidden_lights(void **state) {
    (void)state;
    static const char *const flags[] = {"true", "false"};
    for (int hidden = 0; hidden < 2; hidden++) {
        struct opened opened;
        char nodes[512];
        snprintf(
            nodes, sizeof nodes,
            "[{\"children\": [1, 2, 3], \"extensions\": {\"KHR_node_visibility\": {\"visible\":"
            " %s}}}, {\"mesh\": 0}, {\"extensions\": {\"KHR_lights_punctual\": {\"light\":"
            " 0}}}, {\"camera\": 0}]",
            flags[hidden]);
        check_ok(flags[hidden],
                 open_parts(&opened,
                            &(struct gltf_parts){
                                .nodes = nodes,
                                .materials = "[{\"emissiveFactor\": [1, 1, 1]}]",
                                .more = "\"extensions\": {\"KHR_lights_punctual\": {\"lights\": ["
                                        "{\"type\": \"point\"}]}}, \"cameras\": [{\"type\":"
                                        " \"orthographic\", \"orthographic\": {\"xmag\": 1,"
                                        " \"ymag\": 1, \"znear\": 0, \"zfar\": 9}}],"},
                            (struct scene_choice){0}));
        check_near("lights", emitter_node_count(&opened.scene), hidden ? 0 : 2, 0);
        check_near("cameras", camera_node_count(&opened.scene), 1, 0);
        close_parts(&opened);
    }
}

/* --- scenes and variants ---------------------------------------------------------------------- */

static const struct gltf_parts choices = {
    .nodes = "[{\"mesh\": 0}, {\"mesh\": 1, \"translation\": [0, 0, 5]}]",
    .materials = "[{\"name\": \"plain\"}, {\"name\": \"red\"}, {\"name\": \"blue\"}]",
    .meshes =
        "[{\"primitives\": [{\"attributes\": {\"POSITION\": 0}, \"indices\": 1, \"material\": 0,"
        " \"extensions\": {\"KHR_materials_variants\": {\"mappings\": [{\"material\": 2,"
        " \"variants\": [1, 2]}, {\"material\": 1, \"variants\": [0]}]}}}]},"
        " {\"primitives\": [{\"attributes\": {\"POSITION\": 0}, \"indices\": 1}]}]",
    .more = "\"scene\": 1, \"scenes\": [{\"name\": \"hall\", \"nodes\": [0]}, {\"nodes\": [1]},"
            " {\"name\": \"both\", \"nodes\": [0, 1]}], \"extensions\":"
            " {\"KHR_materials_variants\": {\"variants\": [{\"name\": \"beach\"}, {\"name\":"
            " \"street\"}, {\"name\": \"0\"}]}},"};

static void check_choice(const char *scene, const char *variant, unsigned quads, double z,
                         const char *material) {
    struct opened opened;
    check_ok(scene ? scene : "the default",
             open_parts(&opened, &choices, (struct scene_choice){scene, variant}));
    check_near("quads", opened.geometry.index_count / 6., quads, 0);
    check_near("z", (double)opened.geometry.position[0][2], z, 0);
    int index = opened.scene.meshes[0].primitives[0].material;
    assert_string_equal(opened.scene.materials[index].name, material);
    assert_int_equal(opened.scene.scenes.count, 3);
    assert_string_equal(opened.scene.variants.names[1], "street");
    if (strstr(notes, "variants"))
        fail_msg("a note that is not due: %s", notes);
    close_parts(&opened);
}

static void test_choice(void **state) {
    (void)state;
    struct opened opened;
    check_choice(NULL, NULL, 1, 5, "plain");
    check_choice("", "", 1, 5, "plain");
    check_choice("0", "beach", 1, 0, "red");
    check_choice("hall", "1", 1, 0, "blue");
    check_choice("1", "street", 1, 5, "blue");
    check_choice("both", "0", 2, 0, "blue");
    check_refused(open_parts(&opened, &choices, (struct scene_choice){"3", NULL}),
                  "no scene '3' (there is: 0=hall 1 2=both)");
    check_refused(open_parts(&opened, &choices, (struct scene_choice){NULL, "sea"}),
                  "no variant 'sea' (there is: 0=beach 1=street 2=0)");
    check_refused(open_parts(&opened, &(struct gltf_parts){0}, (struct scene_choice){NULL, "0"}),
                  "no variant '0' (there is: none)");
}

/* --- text ------------------------------------------------------------------------------------- */

static void check_name(const char *name, const char *expected, const char *note) {
    struct opened opened;
    char nodes[256];
    snprintf(nodes, sizeof nodes, "[{\"name\": \"%s\", \"mesh\": 0}]", name);
    check_ok(name,
             open_parts(&opened, &(struct gltf_parts){.nodes = nodes}, (struct scene_choice){0}));
    assert_string_equal(opened.scene.nodes[0].name, expected);
    if (*note ? !strstr(notes, note) : strstr(notes, "UTF-8") != NULL)
        fail_msg("%s: not the note '%s':\n%s", name, note, notes);
    close_parts(&opened);
}

#define BAD "\xEF\xBF\xBD"
#define READ_AS "text that is not UTF-8 is read as U+FFFD: byte "

/* Latin-1, GBK, cut and overlong characters, and halves of escaped pairs, which Python writes for a bad byte. */
static void test_names(void **state) {
    (void)state;
    check_name("B\xC3\xBCro \\u00fc \\ud83d\\ude00 \\\\ud800", "Büro ü \xF0\x9F\x98\x80 \\ud800",
               "");
    check_name("B\xFCro", "B" BAD "ro", READ_AS);
    check_name("\xB4\xB0\xBB\xA7", BAD BAD BAD BAD, READ_AS);
    check_name("\xE2\x82", BAD BAD, READ_AS);
    check_name("\xC0\xAF\xED\xA0\x80", BAD BAD BAD BAD BAD, READ_AS);
    check_name("B\\udcfcro", "B" BAD "ro", READ_AS);
    check_name("\\ud83d x", BAD " x", READ_AS);
}

/* A file whose name is not UTF-8 is found. */
static void test_file_names(void **state) {
    (void)state;
    static const char *const uris[] = {"B\xFCro.bin", "B\\udcfcro.bin", "B%FCro.bin"};
    unsigned char bin[PARTS_BIN];
    parts_bin(&(struct gltf_parts){0}, bin);
    write_bytes(scratch("B\xFCro.bin"), bin, sizeof bin);
    for (int i = 0; i < 3; i++) {
        struct opened opened;
        char buffers[128];
        snprintf(buffers, sizeof buffers, "[{\"uri\" : \"%s\", \"byteLength\": 320}]", uris[i]);
        check_ok(uris[i], open_parts(&opened, &(struct gltf_parts){.buffers = buffers},
                                     (struct scene_choice){0}));
        close_parts(&opened);
    }
}

int main(void) {
    log_set_level(LOG_QUIET);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_lists),         cmocka_unit_test(test_hidden),
        cmocka_unit_test(test_hidden_lights), cmocka_unit_test(test_choice),
        cmocka_unit_test(test_names),         cmocka_unit_test(test_file_names),
    };
    return cmocka_run_group_tests_name("shown", tests, NULL, NULL);
}
