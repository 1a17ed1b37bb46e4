/* A scene that arrives: a coarse picture of it comes before its shaders, the step is told, and it
 * can be stopped. */
#define _XOPEN_SOURCE 700
#include "view_inside.h"

#include "viewer/scene/sky.h"

#include <stdatomic.h>

static void begin(void) {
    begin_viewer(&(struct viewer_desc){.width = 100, .height = 90, .auto_exposure = true});
}

/* As long as the scene waits for its shaders. */
static void wait_for_arrival(void) {
    for (int i = 0; i < 20000 && !viewer.opening.is_arriving; i++)
        turn();
    assert_true(viewer.opening.is_arriving);
}

/* How many different greens a texture has. */
static int count_values(const struct texture *texture) {
    OWNED(bitmap) bitmap;
    bool seen[256] = {false};
    int count = 0;
    texture_read_bitmap(texture, &bitmap);
    for (int i = 0; i < bitmap.width * bitmap.height; i++) {
        count += !seen[bitmap.rgba[4 * i + 1]];
        seen[bitmap.rgba[4 * i + 1]] = true;
    }
    return count;
}

TEST(coarse_picture) {
    char text[600] = "";
    bool was_read = false, was_compiled = false;
    begin();
    viewer_open(&viewer, "scenes/cornell-box.glb");
    int values = 0;
    for (int i = 0; i < 60000 && !viewer.has_scene; i++) {
        viewer_tell_opening(&viewer, text, sizeof text);
        was_read |= strstr(text, "reading") != NULL;
        was_compiled |= strstr(text, "faces; compiling shaders") != NULL;
        turn();
        if (values == 0 && viewer.opening.preview.has_texture) {
            printf("    %s: the coarse picture is there\n", text);
            values = count_values(&viewer.opening.preview.texture);
            assert_false(viewer.has_scene);
        }
    }
    printf("    %d greens in it; reading was told: %d, compiling: %d\n", values, was_read,
           was_compiled);
    assert_true(values > 20 && was_read && was_compiled);
    while (viewer.shown.dirty || viewer.shown.coarse || viewer.shown.moving)
        turn();
    turn();
    assert_false(viewer.opening.preview.has_texture); /* the picture has taken its place */
    assert_ptr_equal(viewer.shown.left, &viewer.shown.renderer.composite.display);
}

/* Esc lets a scene go that is read or waits for its shaders; the one before stays. */
TEST(stop) {
    if (!viewer.has_scene)
        skip();
    viewer_open(&viewer, "scenes/gloss.glb");
    viewer_stop_opening(&viewer);
    assert_false(viewer_is_opening(&viewer));
    while (atomic_load(&viewer.opening.loader.state) != LOADER_IDLE)
        turn();
    assert_false(viewer.opening.is_arriving);
    viewer_open(&viewer, "scenes/gloss.glb");
    wait_for_arrival();
    viewer_stop_opening(&viewer);
    assert_false(viewer_is_opening(&viewer));
    for (int i = 0; i < 8; i++)
        turn();
    assert_non_null(strstr(viewer.document.scene.path, "cornell-box"));
    viewer_open(&viewer, "scenes/materials.glb");
    for (int i = 0; i < 60000 && viewer_is_opening(&viewer); i++)
        turn();
    assert_non_null(strstr(viewer.document.scene.path, "materials"));
    assert_null(viewer.opening.leaving.scene.path);
    assert_int_equal(context_message_count(viewer.host.context), 0);
}

/* A sky that waits for its shaders is let go at once, and freed when none are being compiled. */
TEST(stop_sky) {
    if (!viewer.has_scene)
        skip();
    assert_true(viewer_open_sky(&viewer, "scenes/overcast.hdr"));
    for (int i = 0; i < 4; i++)
        turn();
    assert_true(viewer_is_opening(&viewer));
    bool compiles = !compiling_rests(&viewer.compiling);
    viewer_stop_opening(&viewer);
    printf("    shaders are being compiled: %d, afterwards %d\n", compiles,
           !compiling_rests(&viewer.compiling));
    assert_false(viewer_is_opening(&viewer));
    assert_non_null(viewer.opening.leaving_sky);
    for (int i = 0; i < 60000 && viewer.opening.leaving_sky; i++)
        turn();
    assert_null(viewer.opening.leaving_sky);
    assert_null(viewer.document.scene.environment);
}

/* The coarse picture is of the command line's time and clips: the light and the triangles are where
 * they are then. */
TEST(coarse_picture_of_time) {
    const double time = 1.5;
    struct scene scene;
    struct geometry geometry;
    struct emitter light;
    if (!viewer.has_scene)
        skip();
    viewer.desc.time = (float)time;
    viewer.desc.clip = "0";
    viewer_open(&viewer, "scenes/moving-spot.glb");
    wait_for_arrival();
    check_ok("scene", scene_load(&scene, "scenes/moving-spot.glb"));
    check_ok("geometry", geometry_init(&geometry, &scene, 0));
    emitter_place(&light, &scene, 0, 0);
    float first = light.direction[2];
    emitter_place(&light, &scene, 0, time);
    float got = viewer.opening.preview.desc.emitters.items[0].direction[2];
    printf("    the light shines to z %g, at first %g, expected %g\n", (double)got, (double)first,
           (double)light.direction[2]);
    assert_true(got == light.direction[2] && got != first);
    geometry_free(&geometry);
    scene_free(&scene);
    turn_until(!viewer_is_opening(&viewer));
    rest();
    assert_true(viewer.placed.time == time);
    viewer.desc.time = (float)time;
    viewer_open(&viewer, "scenes/metaballs.glb");
    wait_for_arrival();
    check_ok("scene", scene_load(&scene, "scenes/metaballs.glb"));
    check_ok("geometry", geometry_init(&geometry, &scene, 0));
    const struct geometry *coarse = &viewer.opening.arriving.geometry;
    size_t size = sizeof *geometry.position * geometry.vertex_count;
    check_ok("pose", geometry_pose(&geometry, &scene, time));
    assert_int_equal(coarse->vertex_count, geometry.vertex_count);
    assert_memory_equal(coarse->position, geometry.position, size);
    geometry_pose(&geometry, &scene, 0);
    assert_true(coarse->vertex_count != geometry.vertex_count ||
                memcmp(coarse->position, geometry.position, size) != 0);
    geometry_free(&geometry);
    scene_free(&scene);
    turn_until(!viewer_is_opening(&viewer));
    rest();
}

static atomic_bool may_end;

/* The background thread waits here for the coarse picture. */
static bool refuse(void **state, const struct direct_desc *desc) {
    (void)state, (void)desc;
    for (int i = 0; i < 60000 && !atomic_load(&may_end); i++)
        pause_ms(2);
    return error_set("no memory for these shadows");
}

/* A scene that was read and that no renderer can be made for: the window tells why, shows what was
 * there before and no coarse picture, and the command line's options were that scene's. */
TEST(fails_after_reading) {
    if (!viewer.has_scene)
        skip();
    struct direct_method refused = *direct_find("hard");
    refused.init = refuse;
    viewer.wish.direct = &refused;
    viewer.desc.light = "0";
    viewer.desc.time = 1;
    viewer_open(&viewer, "scenes/moving-spot.glb");
    wait_for_arrival();
    turn_until(viewer.opening.preview.has_texture);
    atomic_store(&may_end, true);
    turn_until(!viewer_is_opening(&viewer));
    printf("    after it has failed: coarse picture %d, at %g s\n",
           viewer.opening.preview.has_texture, (double)viewer.desc.time);
    assert_true(is_message_told("no memory for these shadows", UI_ERROR));
    assert_true(viewer.has_scene);
    assert_non_null(strstr(viewer.document.scene.path, "metaballs"));
    assert_false(viewer.opening.preview.has_texture);
    assert_null(viewer.desc.light);
    assert_true(viewer.desc.time == 0);
    viewer.wish.direct = NULL;
    viewer_touch(&viewer);
    rest();
}

/* The window ends while a scene arrives. */
TEST(end) {
    if (!viewer.has_scene)
        skip();
    viewer_open(&viewer, "scenes/gloss.glb");
    wait_for_arrival();
    viewer_end(&viewer);
}

RUN_TESTS(open_view_stage, close_view_stage)
