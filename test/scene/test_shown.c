/* Which parts of a file are shown: nodes below a scene's list, nodes that are hidden, the chosen
 * scene and variant. */
#include "gltf_parts.h"

#include "scene/camera.h"
#include "scene/lights/emitter.h"
#include "scene/open.h"

struct opened {
    struct scene scene;
    struct geometry geometry;
};

static bool open_parts(struct opened *opened, const struct gltf_parts *parts, const char *scene,
                       const char *variant) {
    const struct scene_open_desc desc = {.choice = {scene, variant}, .may_be_empty = true};
    hear_notes();
    bool ok = scene_open(&opened->scene, &opened->geometry, write_parts("shown.glb", parts), &desc);
    end_notes();
    return ok;
}

static void close_parts(struct opened *opened) {
    geometry_free(&opened->geometry);
    scene_free(&opened->scene);
}

/* --- the tree --------------------------------------------------------------------------------- */

#define LIFTED "{translation: [0, 0, 1], mesh: 0}"
#define ABOVE(children) "{translation: [0, 0, 7], children: [" children "]}"
#define FAMILY "[" ABOVE("1") ", " LIFTED "]"

/* The scene lists those nodes; the quad is drawn once, at a height, with a note of one node or
 * none. */
static void check_list(const char *nodes, const char *list, double z, int noted) {
    struct opened opened;
    char more[128], note[128] = "drawn once";
    snprintf(more, sizeof more, "scenes: [{nodes: [%s]}],", list);
    check_ok(list, open_parts(&opened, &PARTS(.nodes = nodes, .more = more), "", ""));
    check_near("quads", opened.geometry.index_count / 6., 1, 0);
    check_near(list, (double)opened.geometry.position[0][2], z, 0);
    if (noted >= 0)
        snprintf(note, sizeof note, "below a parent, are drawn once, below it: node %d\n", noted);
    if (!strstr(notes, note) != (noted < 0))
        fail_msg("%s: a note that is not due, or none:\n%s", list, notes);
    close_parts(&opened);
}

TEST(lists) {
    struct opened opened;
    check_list(FAMILY, "0", 8, -1);
    check_list(FAMILY, "1", 1, 1); /* the parent is not in the scene */
    check_list(FAMILY, "0, 1", 8, 1);
    check_list(FAMILY, "1, 0", 8, 1);
    check_list("[" ABOVE("1") ", {children: [2]}, " LIFTED "]", "2, 0", 8, 2);
    check_list("[" LIFTED "]", "0, 0", 1, 0);
    check_list("[" ABOVE("1, 1") ", " LIFTED "]", "0", 8, 1);
    check_list("[" ABOVE("2") ", " ABOVE("2") ", " LIFTED "]", "1", 8, -1); /* a second parent */
    check_list("[" ABOVE("1") ", " ABOVE("0") ", " LIFTED "]", "2", 1, -1); /* a loop outside */
    const struct gltf_parts loop = {.nodes = "[" ABOVE("1") ", " ABOVE("0") "]",
                                    .more = "scenes: [{nodes: [1]}],"};
    check_refused(open_parts(&opened, &loop, "", ""), "node 1: it is its own ancestor");
}

/* --- visibility ------------------------------------------------------------------------------- */

#define VISIBLE(flag) "extensions: {KHR_node_visibility: {" flag "}}"
#define HIDDEN VISIBLE("visible: false")

static void check_visible(const char *nodes, unsigned quads) {
    struct opened opened;
    const struct gltf_parts parts = {.nodes = nodes,
                                     .more = "extensionsRequired: [KHR_node_visibility],"};
    check_ok(nodes, open_parts(&opened, &parts, "", ""));
    check_near("quads", opened.geometry.index_count / 6., quads, 0);
    close_parts(&opened);
}

TEST(hidden) {
    check_visible("[{mesh: 0, " HIDDEN "}, " LIFTED "]", 1);
    check_visible("[{mesh: 0, " VISIBLE("visible: true") "}]", 1);
    check_visible("[{mesh: 0, " VISIBLE("") "}]", 1);
    check_visible("[{children: [1], " HIDDEN
                  "}, {children: [2], " VISIBLE("visible: true") "}, {mesh: 0}]",
                  0);
    check_visible("[{children: [1, 2]}, {mesh: 0, " HIDDEN "}, " LIFTED "]", 1);
    check_visible("[{mesh: 0, extensions: {KHR_node_visibility: {visible: false}, "
                  "EXT_mesh_gpu_instancing: {attributes: {TRANSLATION: 0}}}}]",
                  0);
}

/* A lamp, an emissive quad and a camera: only the camera stays. */
TEST(hidden_lights) {
    static const char *const flags[] = {"true", "false"};
    for (int hidden = 0; hidden < 2; hidden++) {
        struct opened opened;
        const char *nodes =
            form("[{children: [1, 2, 3], extensions: {KHR_node_visibility: {visible: %s}}}, {mesh: "
                 "0}, {extensions: {KHR_lights_punctual: {light: 0}}}, {camera: 0}]",
                 flags[hidden]);
        const struct gltf_parts parts = {
            .nodes = nodes,
            .materials = "[{emissiveFactor: [1, 1, 1]}]",
            .more = "extensions: {KHR_lights_punctual: {lights: [{type: point}]}}, cameras: "
                    "[{type: perspective, perspective: {yfov: 1, znear: 1}}],"};
        check_ok(flags[hidden], open_parts(&opened, &parts, "", ""));
        check_near("lights", emitter_node_count(&opened.scene), hidden ? 0 : 2, 0);
        check_near("cameras", camera_node_count(&opened.scene), 1, 0);
        close_parts(&opened);
    }
}

/* --- scenes and variants ---------------------------------------------------------------------- */

static const struct gltf_parts choices = {
    .nodes = "[{mesh: 0}, {mesh: 1, translation: [0, 0, 5]}]",
    .materials = "[{name: plain}, {name: red}, {name: blue}]",
    .meshes = "[{primitives: [{attributes: {POSITION: 0}, indices: 1, material: 0, extensions: "
              "{KHR_materials_variants: {mappings: [{material: 2, variants: [1, 2]}, {material: 1, "
              "variants: [0]}]}}}]}, {primitives: [{attributes: {POSITION: 0}, indices: 1}]}]",
    .more = "scene: 1, scenes: [{name: hall, nodes: [0]}, {nodes: [1]}, {name: both, nodes: [0, "
            "1]}], extensions: {KHR_materials_variants: {variants: [{name: beach}, {name: street}, "
            "{name: '0'}]}},"};

static void check_choice(const char *scene, const char *variant, unsigned quads, double z,
                         const char *material) {
    struct opened opened;
    check_ok(material, open_parts(&opened, &choices, scene, variant));
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

TEST(choice) {
    struct opened opened;
    check_choice(NULL, NULL, 1, 5, "plain");
    check_choice("", "", 1, 5, "plain");
    check_choice("0", "beach", 1, 0, "red");
    check_choice("hall", "1", 1, 0, "blue");
    check_choice("1", "street", 1, 5, "blue");
    check_choice("both", "0", 2, 0, "blue");
    check_refused(open_parts(&opened, &choices, "3", NULL),
                  "no scene '3' (there is: 0=hall 1 2=both)");
    check_refused(open_parts(&opened, &choices, NULL, "sea"),
                  "no variant 'sea' (there is: 0=beach 1=street 2=0)");
    check_refused(open_parts(&opened, &PARTS(0), NULL, "0"), "no variant '0' (there is: none)");
}

/* --- text ------------------------------------------------------------------------------------- */

static void check_name(const char *name, const char *expected, const char *note) {
    struct opened opened;
    const char *nodes = form("[{name: '%s', mesh: 0}]", name);
    check_ok(name, open_parts(&opened, &PARTS(.nodes = nodes), "", ""));
    assert_string_equal(opened.scene.nodes[0].name, expected);
    if (*note ? !strstr(notes, note) : strstr(notes, "UTF-8") != NULL)
        fail_msg("%s: not the note '%s':\n%s", name, note, notes);
    close_parts(&opened);
}

#define BAD "\xEF\xBF\xBD"
#define READ_AS "text that is not UTF-8 is read as U+FFFD: byte "

/* Latin-1, GBK, cut and overlong characters, and halves of escaped pairs, which Python writes for a
 * bad byte. */
TEST(names) {
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
TEST(file_names) {
    static const char *const uris[] = {"B\xFCro.bin", "B\\udcfcro.bin", "B%FCro.bin"};
    unsigned char bin[PARTS_BIN];
    parts_bin(&PARTS(0), bin);
    write_bytes(scratch("B\xFCro.bin"), bin, sizeof bin);
    for (int i = 0; i < 3; i++) {
        struct opened opened;
        const char *buffers = form("[{uri : '%s', byteLength: 320}]", uris[i]);
        check_ok(uris[i], open_parts(&opened, &PARTS(.buffers = buffers), "", ""));
        close_parts(&opened);
    }
}

RUN_TESTS(be_quiet, NULL)
