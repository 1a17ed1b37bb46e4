/* A program of the first header of ABI 0, which lies beside it and never changes: later libraries must run it. It fills each
 * descriptor and calls each kind of function. */
#include "manylight.h"

#include <stdio.h>

static int fail(const char *what) {
    printf("%s: %s\n", what, manylight_error());
    return 1;
}

int main(int argc, char **argv) {
    struct manylight_device_desc device_desc = {.size = sizeof device_desc, .allow_software = 1};
    struct manylight_scene_desc scene_desc = {.size = sizeof scene_desc, .path = argv[argc - 1]};
    struct manylight_renderer_desc renderer_desc = {.size = sizeof renderer_desc,
                                                    .width = 16,
                                                    .height = 12,
                                                    .settings = "vpls=256",
                                                    .quality = "draft"};
    struct manylight_camera camera = {.size = sizeof camera};
    struct manylight_view view = {.size = sizeof view, .placed = &camera};
    struct manylight_reference_desc reference_desc = {
        .size = sizeof reference_desc, .width = 16, .height = 12, .samples = 2, .view = &view};
    struct manylight_compare_desc compare_desc = {.size = sizeof compare_desc, .metric = "rmse"};
    struct manylight_device_info device_info = {.size = sizeof device_info};
    struct manylight_scene_info scene_info = {.size = sizeof scene_info};
    struct manylight_setting setting = {.size = sizeof setting};
    struct manylight_device *device;
    struct manylight_scene *scene;
    struct manylight_renderer *renderer;
    struct manylight_image *image, *reference;
    int channels;
    double error;
    if (manylight_setting_at(0, &setting) || manylight_device_create(&device_desc, &device) ||
        manylight_device_info(device, &device_info))
        return fail("device");
    if (manylight_scene_open(&scene_desc, &scene) || manylight_scene_info(scene, &scene_info) ||
        manylight_scene_camera(scene, NULL, 0, &camera))
        return fail("scene");
    if (manylight_renderer_create(device, scene, &renderer_desc, &renderer) ||
        manylight_render(renderer, &view) || manylight_read(renderer, NULL, &image))
        return fail("render");
    if (manylight_reference(scene, &reference_desc, &reference) ||
        manylight_compare(image, reference, &compare_desc, &error, NULL) ||
        manylight_image_layer(image, "beauty", NULL, 0, &channels))
        return fail("reference");
    printf("%dx%d, %d channels, %d triangles, %s, error %g\n", manylight_image_width(image),
           manylight_image_height(image), channels, scene_info.triangle_count, device_info.name,
           error);
    manylight_image_free(reference);
    manylight_image_free(image);
    manylight_renderer_free(renderer);
    manylight_scene_free(scene);
    manylight_device_free(device);
    return scene_info.triangle_count > 0 && error > 0 && error < 1 && *setting.name ? 0 : 1;
}
