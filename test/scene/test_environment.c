/* Environments: where their texels lie, which files are refused, how a scene gets one, and that it
 * is seen where no surface is. */
#include "render_support.h"

#include "gltf_parts.h"

#include "base/file/file.h"
#include "base/unit.h"
#include "reference/channels.h"
#include "scene/lights/environment.h"
#include "scene/open.h"
#include "scene/placing.h"
#include "scene/read_rules.h"

#include <cglm/cglm.h>

/* A panorama whose texels tell where they are: R = column + 1, G = row + 1, B = 1. */
static struct image numbered_picture(int width, int height) {
    struct image image;
    image_init(&image, width, height, "R G B");
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++) {
            float *at = image_at(&image, x, y);
            at[0] = (float)(x + 1), at[1] = (float)(y + 1), at[2] = 1;
        }
    return image;
}

static const char *write_picture(const char *name, struct image *image) {
    const char *path = scratch(name);
    remove(path);
    check_ok(name, image_write(image, path));
    image_free(image);
    return path;
}

static const char *write_numbered(const char *name, int width, int height) {
    struct image image = numbered_picture(width, height);
    return write_picture(name, &image);
}

/* --- directions ------------------------------------------------------------------------------- */

static void check_texel(const struct environment *environment, vec3 direction, int x, int y) {
    float radiance[3];
    environment_radiance(environment, direction, radiance);
    printf("    (%g, %g, %g) leads to column %g, row %g\n", (double)direction[0],
           (double)direction[1], (double)direction[2], (double)radiance[0] - 1,
           (double)radiance[1] - 1);
    check_near("column", (double)radiance[0], x + 1, 0);
    check_near("row", (double)radiance[1], y + 1, 0);
}

/* Of 16 columns: -X at the left edge, +X in the middle, +Y at the top. Directions lie just right of
 * and below the corners of texels. */
TEST(directions) {
    struct environment sky;
    check_ok("load", environment_load(&sky, write_numbered("sky.exr", 16, 8)));
    check_texel(&sky, (vec3){-1, -.01F, -.01F}, 0, 4);
    check_texel(&sky, (vec3){-1, .01F, .01F}, 15, 3);
    check_texel(&sky, (vec3){.01F, .01F, -1}, 4, 3);
    check_texel(&sky, (vec3){100, .01F, .01F}, 8, 3);
    check_texel(&sky, (vec3){-.01F, .01F, 1}, 12, 3);
    check_texel(&sky, (vec3){-.01F, 1, -.001F}, 0, 0);
    check_texel(&sky, (vec3){1e-20F, -1, 1e-22F}, 8, 7);
    check_texel(&sky, (vec3){-1, 0, -0.F}, 0, 4);
    sky.turn = 90; /* what was at +Z is now at +X */
    check_texel(&sky, (vec3){1, .01F, .01F}, 12, 3);
    sky.turn = -270;
    check_texel(&sky, (vec3){1, .01F, .01F}, 12, 3);
    sky.turn = 0;
    sky.strength = 2;
    float radiance[3];
    environment_radiance(&sky, (vec3){1, .01F, .01F}, radiance);
    check_near("twice as strong", (double)radiance[2], 2, 0);
    mem_free(sky.texels, sky.path);
}

/* The way back, at any turn; and all texels together are the whole sphere. */
TEST(texels) {
    struct environment sky;
    check_ok("load", environment_load(&sky, write_numbered("sky.exr", 64, 32)));
    double sum = 0;
    int wrong = 0;
    sky.turn = 33;
    for (int y = 0; y < sky.height; y++)
        for (int x = 0; x < sky.width; x++) {
            float direction[3];
            int column, row;
            environment_direction(&sky, x + .01, y + .99, direction);
            environment_texel(&sky, direction, &column, &row);
            wrong += column != x || row != y;
            sum += environment_solid_angle(&sky, y);
        }
    check_near("texels that lead elsewhere", wrong, 0, 0);
    check_near("solid angle of all over 4 pi", sum / (4 * GLM_PI), 1, 1e-12);
    mem_free(sky.texels, sky.path);
}

/* The numbers of a picture that is halved are means, and a row's is the middle by solid angle. */
TEST(wide) {
    struct environment sky;
    if (!is_long_run())
        skip();
    hear_notes();
    check_ok("load", environment_load(&sky, write_numbered("wide.pfm", 8194, 3278)));
    end_notes();
    assert_non_null(strstr(notes, "scaled from 8194 x 3278 to 4097 x 1639"));
    check_near("column", (double)sky.texels[4097 * 800 + 4000][0], 8001.5, 1e-3);
    check_near("row 800", (double)sky.texels[4097 * 800][1], 1601.5, .01);
    check_near("the first row", (double)sky.texels[0][1], 1.75, 1e-5);
    check_near("blue", (double)sky.texels[0][2], 1, 0);
    mem_free(sky.texels, sky.path);
}

/* --- cubes ------------------------------------------------------------------------------------ */

/* Light that changes over a few degrees, and another in each direction. */
static void light_of(const float d[3], float light[3]) {
    light[0] = 1 + .5F * d[0] + .25F * d[1] * d[2];
    light[1] = expf(9 * (.48F * d[0] + .64F * d[1] + .6F * d[2] - 1));
    light[2] = .5F + .4F * sinf(5 * d[2]) * cosf(3 * d[1]);
}

/* Makes the attribute of a text the one that says "cube". */
static void mark_as_cube(const char *path) {
    static const char before[] = "envmap\0string", after[] = "envmap\0envmap";
    struct file_bytes file;
    check_ok(path, file_read(&file, path));
    size_t at = 0;
    while (at + sizeof before < file.size && memcmp(file.data + at, before, sizeof before) != 0)
        at++;
    memcpy(file.data + at, after, sizeof after);
    write_bytes(path, file.data, file.size);
    free(file.data);
}

/* Corners of OpenEXR's squares, from the upper left, by the drawing in ImfEnvmap.h: 1, 2 and 4 are
 * towards +X, +Y and +Z. These are -Z, +Y and +X of the scene, as in panoramas of OpenEXR. */
static const char *write_cube(const char *name, int side, int height, bool marked) {
    static const int corners[6][4] = {{3, 7, 1, 5}, {6, 2, 4, 0}, {6, 7, 2, 3},
                                      {0, 1, 4, 5}, {7, 6, 5, 4}, {2, 3, 0, 1}};
    struct image image;
    image_init(&image, side, height, "R G B");
    image_add_text(&image, "envmap", "\1");
    for (int y = 0; y < height; y++)
        for (int x = 0; x < side; x++) {
            double at[3] = {0}, u = (double)x / (side - 1), v = (double)(y % side) / (side - 1);
            for (int k = 0; k < 4; k++)
                for (int c = 0; c < 3; c++)
                    at[c] += (k % 2 ? u : 1 - u) * (k / 2 ? v : 1 - v) *
                             (corners[y / side % 6][k] >> c & 1 ? 1 : -1);
            vec3 direction = {(float)at[2], (float)at[1], (float)-at[0]};
            vec3_unit(direction);
            light_of(direction, image_at(&image, x, y));
        }
    const char *path = write_picture(name, &image);
    if (marked)
        mark_as_cube(path);
    return path;
}

/* The same as of a panorama whose texels have that light. */
TEST(cube) {
    struct environment sky;
    double worst = 0, sums[2][3] = {{0}};
    check_ok("load", environment_load(&sky, write_cube("cube.exr", 48, 288, true)));
    assert_true(sky.width == 192 && sky.height == 96);
    for (int i = 0; i < sky.width * sky.height; i++) {
        float direction[3], light[3];
        double angle = environment_solid_angle(&sky, i / sky.width);
        environment_direction(&sky, i % sky.width + .5, i / sky.width + .5, direction);
        light_of(direction, light);
        for (int c = 0; c < 3; c++) {
            sums[0][c] += angle * (double)sky.texels[i][c];
            sums[1][c] += angle * (double)light[c];
            worst = fmax(worst, fabs((double)(sky.texels[i][c] - light[c])));
        }
    }
    check_at_most("worst texel", worst, .01);
    for (int c = 0; c < 3; c++)
        check_near("light of all over that of the panorama", sums[0][c] / sums[1][c], 1, 1e-3);
    mem_free(sky.texels, sky.path);
}

/* --- files ------------------------------------------------------------------------------------ */

static void check_sky_refused(const char *path, const char *message) {
    struct environment sky;
    check_refused(environment_load(&sky, path), "");
    if (!strstr(error_get(), path) || !strstr(error_get(), message) || strchr(error_get(), '\n'))
        fail_msg("expected '%s'", message);
}

/* A number that is no radiance is replaced with a note, and refused under --strict. */
static void check_texel_replaced(float value, float expected, const char *note) {
    struct environment sky;
    struct image image = numbered_picture(8, 4);
    image_at(&image, 5, 2)[1] = value;
    const char *path = write_picture("odd.exr", &image);
    hear_notes();
    check_ok(path, environment_load(&sky, path));
    end_notes();
    check_near("instead", (double)sky.texels[2 * 8 + 5][1], (double)expected, 0);
    check_near("beside it", (double)sky.texels[2 * 8 + 5][0], 6, 0);
    if (!strstr(notes, path) || !strstr(notes, note))
        fail_msg("'%s' is not in '%s'", note, notes);
    mem_free(sky.texels, sky.path);
    check_ok("strict", read_rules_set(true, NULL));
    check_sky_refused(path, note);
    check_ok("not strict", read_rules_set(false, NULL));
}

TEST(refusals) {
    remove(scratch("none.exr"));
    check_sky_refused(scratch("none.exr"), "");
    check_sky_refused(write_numbered("square.exr", 8, 8),
                      "8 x 8 pixels are no panorama, which is twice as wide as high");
    check_sky_refused(write_cube("plain.exr", 4, 24, false), "4 x 24 pixels are no panorama");
    check_sky_refused(write_cube("wide.exr", 8, 4, true), "8 x 4 pixels are no cube of light");
    check_texel_replaced(NAN, 0, "1 no numbers (0 instead); first in column 5, row 2");
    check_texel_replaced(-.5F, 0, "1 negative (0 instead); first in column 5, row 2");
    check_texel_replaced(-INFINITY, 0, "1 negative (0 instead); first in column 5, row 2");
    check_texel_replaced(INFINITY, 65504, "1 infinite (65504 instead); first in column 5, row 2");
    struct bitmap bitmap = {2, 1, (unsigned char[8]){0}};
    check_ok("png", bitmap_write(&bitmap, scratch("sky.png")));
    check_sky_refused(scratch("sky.png"), "its format is for displays");
    write_bytes(scratch("cut.hdr"), "#?RADIANCE\n", 11);
    check_sky_refused(scratch("cut.hdr"), "");
}

/* --- scenes ----------------------------------------------------------------------------------- */

static void open_with(struct scene *scene, const struct gltf_parts *parts,
                      const struct environment_desc *environment) {
    struct geometry geometry;
    const struct scene_open_desc desc = {.environment = *environment};
    check_ok("open", scene_open(scene, &geometry, write_parts("scene.glb", parts), &desc));
    geometry_free(&geometry);
}

/* A name in the file, one in its place, and changes of it. */
TEST(scenes) {
    const struct gltf_parts named = {.asset = "{version: '2.0', extras: {environment: 'sky.hdr'}}"};
    const struct gltf_parts strong = {
        .more = "scene: 0, scenes: [{nodes: [0], extras: {environment: 'sky.hdr', environmentTurn: "
                "90, environmentStrength: 3}}],"};
    const char *other = write_numbered("other.exr", 4, 2);
    OWNED(scene) scene;
    write_numbered("sky.hdr", 16, 8);
    open_with(&scene, &named, &(struct environment_desc){0});
    assert_int_equal(scene.environment->width, 16);
    assert_int_equal(scene.light_count, 0); /* no spot stands in */
    assert_false(scene_check_output(&scene, scratch("sky.hdr")));
    scene_free(&scene);
    open_with(&scene, &strong, &(struct environment_desc){.turn = 5, .strength = .5F});
    check_near("turn", (double)scene.environment->turn, 95, 0);
    check_near("strength", (double)scene.environment->strength, 1.5, 0);
    scene_free(&scene);
    open_with(&scene, &strong, &(struct environment_desc){.path = other});
    assert_int_equal(scene.environment->width, 4);
    check_near("turn", (double)scene.environment->turn, 0, 0);
}

static void check_scene_refused(const struct gltf_parts *parts, const struct environment_desc *desc,
                                const char *message) {
    struct scene scene;
    struct geometry geometry;
    const struct scene_open_desc open = {.environment = *desc};
    check_refused(scene_open(&scene, &geometry, write_parts("scene.glb", parts), &open), message);
}

TEST(scene_refusals) {
    static const char *const rows[][2] = {
        {"{environment: '../../sky.hdr'}",
         "extras: environment: '../../sky.hdr' leads out of the folder "},
        {"{environment: 'nowhere.hdr'}", "extras: environment: cannot open"},
        {"{environment: 3}", "extras: environment: it is no file's name"},
        {"{environment: 'sky.hdr', environmentTurn: east}",
         "extras: environmentTurn: it is no number"},
        {"{environment: 'sky.hdr', environmentStrength: -1}",
         "extras: environmentStrength: it is not above 0"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const char *asset = form("{version: '2.0', extras: %s}", rows[i][0]);
        check_scene_refused(&PARTS(.asset = asset), &(struct environment_desc){0}, rows[i][1]);
    }
    check_scene_refused(&PARTS(0), &(struct environment_desc){.turn = 1},
                        "there is no environment to be turned");
    check_scene_refused(&PARTS(0), &(struct environment_desc){.path = scratch("none.exr")},
                        "none.exr");
}

static void check_lights(const struct scene *scene, const char *text, int count, bool sky) {
    OWNED(emitters) emitters = {0}, again = {0};
    check_ok(text, emitters_from_text(&emitters, scene, text, 0));
    char *written = emitters_to_text(&emitters, scene, 0);
    printf("    %-24s %s\n", text, written);
    assert_int_equal(emitters.count, count);
    assert_ptr_equal(emitters.sky, sky ? scene->environment : NULL);
    check_ok(written, emitters_from_text(&again, scene, written, 0));
    assert_true(emitters_same(&again, &emitters));
    free(written);
}

TEST(choice) {
    OWNED(scene) scene;
    OWNED(geometry) geometry;
    struct emitters emitters = {0};
    const struct scene_open_desc desc = {.environment = {.path = write_numbered("s.exr", 4, 2)}};
    check_ok("open", scene_open(&scene, &geometry, "scenes/three-lights.glb", &desc));
    check_lights(&scene, "", 3, true);
    check_lights(&scene, "sky", 0, true);
    check_lights(&scene, "1,sky", 1, true);
    check_lights(&scene, "1", 1, false);
    check_lights(&scene, "sky; 2 intensity=1,2,3", 1, true);
    geometry_free(&geometry);
    scene_free(&scene);
    check_ok("open", scene_open(&scene, &geometry, "scenes/three-lights.glb", NULL));
    assert_false(emitters_from_text(&emitters, &scene, "sky", 0));
}

/* --- pictures --------------------------------------------------------------------------------- */

/* Looks past a quad at a sky of many texels: GL and rays see the same one in every pixel. */
TEST(background) {
    enum { SIZE = 48 };
    OWNED(stage) stage;
    const struct stage_desc desc = {
        .path = write_parts("scene.glb", &PARTS(0)),
        .light = "sky",
        .camera = "eye=.5,.5,3 forward=.1,.2,-1 fov=1.5",
        .environment = {.path = write_numbered("sky.exr", 16, 8), .turn = 20, .strength = .5F},
    };
    check_ok("stage", stage_init(&stage, &desc));
    OWNED(image) shown = render_stage(&stage, "unshadowed", "", SIZE);
    OWNED(image) traced =
        TRACE(&stage, .width = SIZE, .height = SIZE, .samples = 1, .centers = true);
    int sky = 0, other = 0;
    for (int y = 0; y < SIZE; y++)
        for (int x = 0; x < SIZE; x++) {
            const float *at = image_at(&traced, x, y), *in_gl = image_at(&shown, x, y);
            bool is_sky = at[CHANNEL_ALPHA] == 0;
            sky += is_sky;
            other += is_sky && (at[0] != in_gl[0] || at[1] != in_gl[1] || at[2] != in_gl[2] ||
                                at[0] != at[CHANNEL_EMITTED] || in_gl[CHANNEL_ALPHA] != 0);
        }
    check_near("pixels of sky, of 2304", sky, 2230, 30);
    check_at_most("of them with another radiance in GL", other, 4);
}

RUN_TESTS(open_group_context, close_group_context)
