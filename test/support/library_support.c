#include "library_support.h"

#include "base/file/file.h"

void check_call(const char *what, enum manylight_status status) {
    if (status)
        printf("    %s: status %d: %s\n", what, status, manylight_error());
    assert_int_equal(status, MANYLIGHT_OK);
}

void check_failed(enum manylight_status status, enum manylight_status wanted, const char *text) {
    printf("    status %d: %s\n", status, manylight_error());
    assert_int_equal(status, wanted);
    assert_int_equal(manylight_error_status(), wanted);
    expect_in(manylight_error(), text);
}

struct manylight_device *open_device(void) {
    struct manylight_device *device;
    const struct manylight_device_desc desc = {.size = sizeof desc, .allow_software = 1};
    check_call("device", manylight_device_create(&desc, &device));
    return device;
}

struct manylight_scene *open_scene(const char *path) {
    struct manylight_scene *scene;
    const struct manylight_scene_desc desc = {.size = sizeof desc, .path = path};
    check_call(path, manylight_scene_open(&desc, &scene));
    return scene;
}

struct manylight_renderer *open_drawing(struct manylight_device *device,
                                        struct manylight_scene *scene,
                                        const struct manylight_renderer_desc *desc) {
    struct manylight_renderer *renderer;
    struct manylight_renderer_desc small = {0};
    if (desc)
        small = *desc;
    small.size = sizeof small;
    if (small.width == 0) {
        small.width = 48;
        small.height = 40;
    }
    check_call("renderer", manylight_renderer_create(device, scene, &small, &renderer));
    return renderer;
}

struct manylight_image *draw_once(struct manylight_device *device, struct manylight_scene *scene,
                                  const struct manylight_renderer_desc *desc,
                                  const struct manylight_view *view) {
    struct manylight_image *image;
    struct manylight_renderer *renderer = open_drawing(device, scene, desc);
    check_call("render", manylight_render(renderer, view));
    check_call("read", manylight_read(renderer, NULL, &image));
    manylight_renderer_free(renderer);
    return image;
}

bool same_images(const struct manylight_image *a, const struct manylight_image *b) {
    int channels = manylight_image_channel_count(a);
    size_t count =
        (size_t)manylight_image_width(a) * (size_t)manylight_image_height(a) * (size_t)channels;
    bool same = channels == manylight_image_channel_count(b) &&
                manylight_image_width(a) == manylight_image_width(b) &&
                manylight_image_height(a) == manylight_image_height(b);
    for (int i = 0; same && i < channels; i++)
        same = strcmp(manylight_image_channel(a, i), manylight_image_channel(b, i)) == 0;
    return same &&
           memcmp(manylight_image_pixels(a), manylight_image_pixels(b), count * sizeof(float)) == 0;
}

static bool same_files(const char *a, const char *b) {
    struct file_bytes of_a, of_b;
    check_ok(a, file_read(&of_a, a));
    check_ok(b, file_read(&of_b, b));
    bool same = of_a.size == of_b.size && memcmp(of_a.data, of_b.data, of_a.size) == 0;
    mem_free(of_a.data, of_b.data);
    return same;
}

void check_same_as_file(struct manylight_image *image, const char *path) {
    struct manylight_image *own, *theirs;
    check_call("write", manylight_image_write(image, scratch("own.exr")));
    check_call("read", manylight_image_read(scratch("own.exr"), &own));
    check_call("read", manylight_image_read(path, &theirs));
    printf("    %d channels of %dx%d\n", manylight_image_channel_count(own),
           manylight_image_width(own), manylight_image_height(own));
    assert_true(same_images(own, theirs));
    /* The attributes of the header, too. */
    assert_true(same_files(scratch("own.exr"), path));
    manylight_image_free(own);
    manylight_image_free(theirs);
}
