/* Files with small defects that other readers open: each opens here with a note, and not under
 * --strict. */
#define _GNU_SOURCE
#include "mended_parts.h"

#include "scene/open.h"
#include "scene/read_rules.h"

#include <unistd.h>

/* Opens the file, and hears its notes. */
static bool open_file(struct scene *scene, const char *path) {
    struct geometry geometry;
    hear_notes();
    bool ok = scene_open(scene, &geometry, path, NULL);
    end_notes();
    if (ok)
        geometry_free(&geometry);
    return ok;
}

static void check_strict(const char *what, const char *path, bool opens) {
    struct scene scene;
    check_ok("strict", read_rules_set(true, NULL));
    bool ok = open_file(&scene, path);
    check_ok("not strict", read_rules_set(false, NULL));
    if (ok)
        scene_free(&scene);
    if (ok != opens)
        fail_msg("%s: --strict %s it: %s", what, ok ? "opens" : "refuses", error_get());
    if (!ok && (!strstr(error_get(), path) || strchr(error_get(), '\n')))
        fail_msg("%s: '%s' does not name the file in a line", what, error_get());
}

/* One note a kind, which names the file; lacks are no defects. */
static void check_note(const char *what, const char *path, const char *note) {
    const char *found = strstr(notes, note);
    printf("    %-36s %s\n", what, *note ? note : "no note");
    if (!found || (*note && !strstr(notes, path)))
        fail_msg("%s: '%s' is not in:\n%s", what, note, notes);
    if (!*note && (strstr(notes, "taken") || strstr(notes, "left out") || strstr(notes, "ignored")))
        fail_msg("%s: a note that is not due:\n%s", what, notes);
    check_strict(what, path, !*note || strncmp(note, "shown", 5) == 0);
}

static void check_files(const struct mended *files, size_t count) {
    int opened = 0;
    for (const struct mended *file = files; file < files + count; file++) {
        struct scene scene;
        const char *path = write_parts("mended.glb", &file->parts);
        check_ok(file->name, open_file(&scene, path));
        scene_free(&scene);
        check_note(file->name, path, file->note);
        opened++;
    }
    printf("    %d of %zu opened\n", opened, count);
}

TEST(mended) {
    check_files(mended, sizeof mended / sizeof *mended);
}

TEST(valid) {
    check_files(valid, sizeof valid / sizeof *valid);
}

/* What is mended is what it should have been. */
TEST(values) {
    OWNED(scene) scene;
    check_ok("share",
             load_parts(&scene, "v.glb",
                        &PARTS(.materials = MATERIAL("roughnessFactor: 1.5, metallicFactor: -1, "
                                                     "baseColorFactor: [2, 0.25, -1]"))));
    const struct material *material = &scene.materials[0];
    check_near("roughness", (double)material->roughness, 1, 0);
    check_near("metalness", (double)material->metalness, 0, 0);
    check_near("red", (double)material->base_color[0], 1, 0);
    check_near("green", (double)material->base_color[1], .25, 0);
    check_near("blue", (double)material->base_color[2], 0, 0);
    check_near("alpha", (double)material->base_color[3], 1, 0);
    scene_free(&scene);
    check_ok("turn", load_parts(&scene, "v.glb", &PARTS(.nodes = NODE("rotation: [0, 0, 0, 0]"))));
    check_near("no turn", (double)scene.nodes[0].rotation[3], 1, 0);
    scene_free(&scene);
    check_ok("seven", load_parts(&scene, "v.glb", &PARTS(.accessors = COUNTS("4", "7"))));
    check_near("indices", scene.meshes[0].primitives[0].index_count, 6, 0);
    scene_free(&scene);
    check_ok("strided", load_parts(&scene, "v.glb",
                                   &PARTS(.views = TWO_VIEWS("", ", byteStride: 4"),
                                          .accessors = IN_TWO_VIEWS)));
    check_near("the last corner", (double)scene.meshes[0].primitives[0].position[5][0], 0, 0);
    check_near("the last corner", (double)scene.meshes[0].primitives[0].position[5][1], 1, 0);
}

/* --- clips ------------------------------------------------------------------------------------ */

/* Two channels of a clip: that of the node's translation is good, the other is the test's. */
struct keys {
    float good_times[2], good_values[2][3], times[3], values[3][4];
};

static const struct keys good_keys = {
    {0, 1}, {{0, 0, 0}, {0, 0, 5}}, {0, 1, 2}, {{0, 0, 0, 1}, {0, 0, 1, 0}, {0, 0, 0, 1}}};

#define FLOATS(offset, count, type)                                                                \
    "{bufferView: 0, byteOffset: " offset ", componentType: 5126, count: " count ", type: '" type  \
    "'}"

static void check_clip(const char *what, const struct keys *keys, const char *output,
                       const char *sampler, const char *target, const char *note) {
    const char *accessors =
        form("[{bufferView: 0," VECTORS "}, {bufferView: 0, byteOffset: 48," INDEX_TYPE
             "}, " FLOATS("64", "2", "SCALAR") ", " FLOATS("72", "2", "VEC3") ", " FLOATS(
                 "96", "3", "SCALAR") ", %s]",
             output);
    const char *more =
        form("animations: [{name: both, samplers: [{input: 2, output: 3}, %s], channels: "
             "[{sampler: 1, %s}, {sampler: 0, target: {node: 0, path: translation}}]}],",
             sampler, target);
    const struct gltf_parts parts = {
        .accessors = accessors, .more = more, .extra = keys, .extra_size = sizeof *keys};
    const char *path = write_parts("clip.glb", &parts);
    struct scene scene;
    check_ok(what, open_file(&scene, path));
    check_near(what, scene.clips[0].channel_count, *note ? 1 : 2, 0);
    float(*worlds)[16] = mem_alloc((size_t)scene.node_count, sizeof *worlds);
    scene_node_worlds(&scene, 1, worlds);
    check_near("the good channel plays", (double)worlds[0][14], 5, 0);
    free(worlds);
    scene_free(&scene);
    check_note(what, path, note);
}

#define TURNS FLOATS("108", "3", "VEC4")
#define SAMPLER "{input: 4, output: 5}"
#define TURNED "target: {node: 0, path: rotation}"
#define BAD "channels of clips that are not valid are left out: animation 0 'both': channel 0: "

static struct keys with_times(float a, float b, float c) {
    struct keys keys = good_keys;
    keys.times[0] = a;
    keys.times[1] = b;
    keys.times[2] = c;
    return keys;
}

TEST(clips) {
    struct keys keys = good_keys;
    check_clip("good", &keys, TURNS, SAMPLER, TURNED, "");
    keys = with_times(0, 1, 1);
    check_clip("equal times", &keys, TURNS, SAMPLER, TURNED, BAD "input: time 2 is 1 s");
    keys = with_times(0, 2, 1);
    check_clip("falling times", &keys, TURNS, SAMPLER, TURNED, BAD "input: time 2 is 1 s");
    keys = with_times(-1, 0, 1);
    check_clip("negative times", &keys, TURNS, SAMPLER, TURNED, BAD "input: time 0 is -1 s");
    keys = with_times(0, NAN, 1);
    check_clip("times of NaN", &keys, TURNS, SAMPLER, TURNED, BAD "input: time 1 is nan s");
    keys = good_keys;
    keys.values[1][2] = NAN;
    check_clip("values of NaN", &keys, TURNS, SAMPLER, TURNED, BAD "output: number 6 is nan");
    keys = good_keys;
    keys.values[2][3] = 0;
    check_clip("turn of 0", &keys, TURNS, SAMPLER, TURNED, BAD "output: value 2 is a quaternion");
    keys = good_keys;
    check_clip("a value too many", &keys, FLOATS("108", "4", "VEC4"), SAMPLER, TURNED,
               BAD "output: 4 elements, not 3");
    check_clip("a value too few", &keys, FLOATS("108", "2", "VEC4"), SAMPLER, TURNED,
               BAD "output: 2 elements, not 3");
    check_clip("values of another type", &keys, FLOATS("108", "3", "VEC2"), SAMPLER, TURNED,
               BAD "output: accessor 5 has 2 numbers an element, not 4");
    check_clip("turns without their fourth number", &keys, FLOATS("108", "3", "VEC3"), SAMPLER,
               TURNED, BAD "output: accessor 5 has 3 numbers an element, not 4");
    check_clip("cubic with too few", &keys, TURNS,
               "{input: 4, output: 5, interpolation: CUBICSPLINE}", TURNED,
               BAD "output: 3 elements, not 9");
    check_clip("no such interpolation", &keys, TURNS,
               "{input: 4, output: 5, interpolation: BEZIER}", TURNED,
               BAD "sampler 1: interpolation: \"BEZIER\" is none of");
    check_clip("no input", &keys, TURNS, "{output: 5}", TURNED, BAD "sampler 1: it has no 'input'");
    check_clip("no such output", &keys, TURNS, "{input: 4, output: 50}", TURNED,
               BAD "sampler 1: output: 50, but there are 6 accessors");
    check_clip("a sampler of 7", &keys, TURNS, "7", TURNED, BAD "sampler 1: 7 is not an object");
    check_clip("no such node", &keys, TURNS, SAMPLER, "target: {node: 9, path: rotation}",
               BAD "target: node: 9, but there are 1 nodes");
    check_clip("no path", &keys, TURNS, SAMPLER, "target: {node: 0}",
               BAD "target: it has no 'path'");
    check_clip("weights for nothing", &keys, TURNS, SAMPLER, "target: {node: 0, path: weights}",
               BAD "weights of a node without morph targets");
}

/* --- pictures --------------------------------------------------------------------------------- */

static void check_texel(const char *what, const struct scene *scene, int texture, int x, int r,
                        int g, int b) {
    const unsigned char *rgba = scene->textures[texture].bitmap.rgba + (size_t)x * 4;
    printf("    %-36s %d %d %d\n", what, rgba[0], rgba[1], rgba[2]);
    assert_true(rgba[0] == r && rgba[1] == g && rgba[2] == b);
}

/* A colour becomes a checker; other textures change nothing, and none of them shines. */
TEST(stand_ins) {
    struct scene scene;
    write_bytes(scratch("broken.png"), "\x89PNG\r\n\x1a\nand no more", 19);
    const char *path = write_parts(
        "pictures.glb",
        &PARTS(.materials = "[{pbrMetallicRoughness: {baseColorTexture: {index: 0}, "
                            "metallicRoughnessTexture: {index: 1}}, emissiveFactor: [1, 1, 1], "
                            "emissiveTexture: {index: 2}, normalTexture: {index: 3}}]",
               .more = "images: [{uri: 'none.png'}, {uri: 'broken.png'}, {uri: 'none.jpg'}, "
                       "{bufferView: 0}], textures: [{source: 0}, {source: 1}, {source: 2}, "
                       "{source: 3}],"));
    check_ok("open", open_file(&scene, path));
    const struct material *material = &scene.materials[0];
    check_texel("base colour", &scene, material->base_color_texture, 0, 255, 0, 255);
    check_texel("base colour, next square", &scene, material->base_color_texture, 4, 0, 0, 0);
    check_texel("rough, no metal", &scene, material->metal_roughness_texture, 0, 0, 255, 0);
    check_texel("no emission", &scene, material->emission_texture, 0, 0, 0, 0);
    check_texel("a straight normal", &scene, material->normal_texture, 0, 128, 128, 255);
    scene_free(&scene);
    check_note("pictures", path, "replaced, colours by a magenta checker: image 0: cannot open");
    if (!strstr(error_get(), "--strict"))
        fail_msg("'%s' does not name --strict", error_get());
}

RUN_TESTS(be_quiet, NULL)
