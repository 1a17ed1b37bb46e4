/* The scene floor: geometry, lights and cameras of glTF files. */
#define _XOPEN_SOURCE 700
#include "support.h"

#include "scene/camera.h"
#include "scene/geometry.h"
#include "scene/light.h"

#include <math.h>
#include <stdio.h>

/* ../shared/scenes/NAME; false where it is absent. */
static bool load_shared(struct scene *scene, const char *name) {
    char path[256];
    if (!shared_path())
        return false;
    snprintf(path, sizeof path, "%s/scenes/%s", shared_path(), name);
    check_ok(path, scene_load(scene, path));
    return true;
}

static void test_shared_scenes(void **state) {
    (void)state;
    static const struct {
        const char *name;
        int triangles;
    } expected[] = {{"cornell-box.glb", 30},
                    {"cornell-horse.glb", 17000},
                    {"sponza-98k.glb", 97999},
                    {"sponza.glb", 262196}};
    for (int i = 0; i < 4; i++) {
        struct scene scene;
        struct geometry geometry;
        if (!load_shared(&scene, expected[i].name))
            skip();
        check_ok("geometry", geometry_init(&geometry, &scene, 0));
        check_near(expected[i].name, geometry.index_count / 3, expected[i].triangles, 0);
        assert_int_equal(light_node_count(&scene), 1);
        assert_int_equal(camera_node_count(&scene), 1);
        geometry_free(&geometry);
        scene_free(&scene);
    }
}

/* The figures of ../shared/scenes/README.md. */
static void test_cornell_box(void **state) {
    (void)state;
    struct scene scene;
    if (!load_shared(&scene, "cornell-box.glb"))
        skip();
    struct light light;
    light_place(&light, &scene, 0, 0);
    const float position[] = {1.1F, 2.3F, 1.9F}, direction[] = {-.778F, .592F, -.209F};
    for (int c = 0; c < 3; c++) {
        check_near("light position", light.position[c], position[c], 1e-3);
        check_near("light direction", light.direction[c], direction[c], 1e-3);
        check_near("light intensity", light.intensity[c], 500, 1e-3);
    }
    check_near("outer", acos(light.cos_outer) * 180 / M_PI, 29, 1e-3);
    struct camera camera;
    camera_place(&camera, &scene, 0, 0);
    check_near("eye y", camera.eye[1], 2.73, 1e-3);
    check_near("eye z", camera.eye[2], 10.796, 1e-3);
    check_near("forward z", camera.forward[2], -1, 1e-6);
    check_near("fov", camera.fov_y * 180 / M_PI, 39.31, 1e-2);
    scene_free(&scene);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_shared_scenes),
        cmocka_unit_test(test_cornell_box),
    };
    return cmocka_run_group_tests_name("scene", tests, NULL, NULL);
}
