/* The viewer's camera and its time, by real input events: what is under the mouse is circled,
 * zoomed to and framed; views are kept; a clip is stepped through. */
#define _XOPEN_SOURCE 700
#include "base/unit.h"
#include "view_stage.h"

#include "scene/placing.h"
#include "viewer/scene/orbit.h"

#define BOX "scenes/cornell-box.glb"
#define MOVING "scenes/metaballs.glb"

static const float aspect = (float)WIDTH / HEIGHT;

/* --- without a window ------------------------------------------------------------------------- */

/* A point that was grabbed stays where it is in the picture. */
static void check_place(const char *what, const struct orbit *orbit, const float point[3],
                        const float before[2]) {
    float at[2];
    assert_true(camera_project(&orbit->camera, point, aspect, at));
    printf("    %-48s %.5f %.5f, then %.5f %.5f\n", what, (double)before[0], (double)before[1],
           (double)at[0], (double)at[1]);
    assert_true(hypotf(at[0] - before[0], at[1] - before[1]) < 1e-4F);
}

TEST(orbit) {
    struct camera camera = {.eye = {1, 2, 9}, .fov_y = 1};
    camera_look(&camera, camera.eye, (float[]){-.1F, -.2F, -1}, (float[]){0, 1, 0});
    const float center[3] = {0, 0, 0}, point[3] = {.7F, .5F, 2};
    struct orbit orbit;
    float before[2];
    orbit_start(&orbit, &camera, center, 5);
    assert_true(camera_project(&orbit.camera, point, aspect, before));
    orbit_grab(&orbit, point);
    orbit_turn(&orbit, .2F, -.1F);
    check_place("circled", &orbit, point, before);
    orbit_zoom(&orbit, 3);
    check_place("zoomed to", &orbit, point, before);
    float there = glm_vec3_distance(orbit.camera.eye, (float *)point);
    orbit_zoom(&orbit, -200);
    orbit_zoom(&orbit, 200);
    printf("    %.4g m away, after all the way out and in %.4g m\n", (double)there,
           (double)glm_vec3_distance(orbit.camera.eye, (float *)point));
    assert_true(glm_vec3_distance(orbit.camera.eye, (float *)point) > 1e-4F);
    orbit_frame(&orbit, point, 1, aspect);
    float at[2];
    assert_true(camera_project(&orbit.camera, point, aspect, at));
    assert_true(fabsf(at[0] - .5F) < 1e-4F && fabsf(at[1] - .5F) < 1e-4F);
}

/* --- in the window ---------------------------------------------------------------------------- */

static struct camera camera_of(const char *text) {
    OWNED(scene) scene;
    struct camera camera;
    check_ok(BOX, scene_load(&scene, BOX));
    check_ok(text, camera_from_text(&camera, &scene, text, 0, NULL));
    return camera;
}

static struct camera saved_camera(void) {
    char text[600];
    save_settings();
    read_setting("camera", text, sizeof text);
    printf("    %s\n", text);
    return camera_of(text);
}

/* Where the mouse was: below on the left, on the floor. */
enum { MOUSE_X = 70, MOUSE_Y = 620 };

static void ray_of(const struct camera *camera, vec3 origin, vec3 direction) {
    camera_ray(camera, (MOUSE_X + .5F) / WIDTH, (MOUSE_Y + .5F) / HEIGHT, aspect, origin,
               direction);
}

TEST(zoom) {
    start_viewer(BOX, "");
    struct camera before = saved_camera();
    xdo("mousemove %d %d click 4 click 4 click 4", MOUSE_X, MOUSE_Y);
    struct camera after = saved_camera();
    vec3 origin, direction, way;
    ray_of(&before, origin, direction);
    glm_vec3_sub(after.eye, before.eye, way);
    float angle = glm_deg(glm_vec3_angle(way, direction));
    printf("    went %.4g m, %.3g degrees beside the mouse\n", (double)glm_vec3_norm(way),
           (double)angle);
    assert_true(glm_vec3_norm(way) > .5F && angle < .5F);
}

/* The rays through the mouse's place, before and after, meet. */
TEST(circle) {
    need_viewer();
    vec3 o1, d1, o2, d2, between, across;
    struct camera before = saved_camera();
    xdo("mousemove %d %d mousedown 1 mousemove %d %d mouseup 1", MOUSE_X, MOUSE_Y, MOUSE_X + 40,
        MOUSE_Y - 30);
    struct camera after = saved_camera();
    ray_of(&before, o1, d1);
    ray_of(&after, o2, d2);
    glm_vec3_sub(o2, o1, between);
    vec3_unit_cross(d1, d2, across);
    float apart = fabsf(glm_vec3_dot(between, across)), turned = glm_deg(glm_vec3_angle(d1, d2));
    printf("    turned by %.3g degrees; the rays miss each other by %.3g m\n", (double)turned,
           (double)apart);
    assert_true(turned > 5 && apart < .02F);
}

TEST(views) {
    need_viewer();
    struct camera kept = saved_camera();
    xdo("mousemove %d %d key ctrl+3 key r", WIDTH / 2, HEIGHT / 2);
    struct camera home = saved_camera();
    assert_false(cameras_same(&kept, &home));
    xdo("key alt+3");
    struct camera again = saved_camera();
    assert_true(cameras_same(&kept, &again));
    char view[600], camera[600];
    read_setting("view3", view, sizeof view);
    read_setting("camera", camera, sizeof camera);
    assert_string_equal(view, camera);
    const char *arguments = form(BOX " --camera \"%s\"", view);
    check_same("a view that was kept", arguments);
}

/* F frames the block that the mouse is on, from the same side; Shift and the wheel change
 * the lens. */
TEST(frame) {
    need_viewer();
    xdo("key r");
    struct camera home = saved_camera();
    xdo("mousemove %d %d key f", WIDTH / 4, HEIGHT / 2);
    struct camera framed = saved_camera();
    assert_true(glm_vec3_distance(home.eye, framed.eye) > .2F);
    assert_true(glm_vec3_distance(home.forward, framed.forward) < 1e-6F);
    xdo("key r keydown shift click 4 keyup shift");
    struct camera lens = saved_camera();
    printf("    field of view %.4g, then %.4g degrees\n", (double)glm_deg(home.fov_y),
           (double)glm_deg(lens.fov_y));
    assert_true(lens.fov_y < .98F * home.fov_y);
    assert_true(glm_vec3_distance(home.eye, lens.eye) == 0);
    end_viewer();
}

/* --- time ------------------------------------------------------------------------------------- */

TEST(steps) {
    need_server();
    start_viewer(MOVING, "");
    sync_viewer();
    xdo("key period key period key period key comma");
    check_same("three frames on and one back", MOVING " --time 0.08");
    press(">");
    check_same("by its button", MOVING " --time 0.12");
    end_viewer();
}

RUN_TESTS(open_view_stage, close_view_stage)
