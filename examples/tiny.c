/* A scene in, a picture of floats out: the shortest program with libmanylight.
 *
 *     cc tiny.c -o tiny $(pkg-config --cflags --libs manylight)
 *     ./tiny scene.glb picture.exr [WIDTH HEIGHT]
 *
 * It prints the mean radiance of each layer. Without a GPU it renders on the CPU. */
#include <manylight.h>

#include <stdio.h>
#include <stdlib.h>

static void tell(void *user, enum manylight_log_level level, const char *message) {
    (void)user;
    if (level != MANYLIGHT_DETAIL)
        fprintf(stderr, "tiny: %s\n", message);
}

static double mean_of(const float *floats, size_t count) {
    double sum = 0;
    for (size_t i = 0; i < count; i++)
        sum += floats[i];
    return sum / (double)count;
}

/* Floats of a layer: height x width x channels, row 0 at the top. */
static int print_layer(const struct manylight_image *image, const char *name) {
    size_t pixels = (size_t)manylight_image_width(image) * (size_t)manylight_image_height(image);
    int channels = 0;
    if (manylight_image_layer(image, name, NULL, 0, &channels))
        return 0;
    size_t count = pixels * (size_t)channels;
    float *floats = malloc(count * sizeof *floats);
    int ok = floats && !manylight_image_layer(image, name, floats, count, NULL);
    if (ok)
        printf("%-10s %d channels, mean %.6g\n", name, channels, mean_of(floats, count));
    free(floats);
    return ok;
}

static int run(const char *path, const char *output, int width, int height) {
    struct manylight_device_desc device_desc = {.size = sizeof device_desc, .allow_software = 1};
    struct manylight_scene_desc scene_desc = {.size = sizeof scene_desc, .path = path};
    struct manylight_renderer_desc renderer_desc = {
        .size = sizeof renderer_desc, .width = width, .height = height};
    struct manylight_device *device = NULL;
    struct manylight_scene *scene = NULL;
    struct manylight_renderer *renderer = NULL;
    struct manylight_image *image = NULL;
    int ok = !manylight_scene_open(&scene_desc, &scene) &&
             !manylight_device_create(&device_desc, &device) &&
             !manylight_renderer_create(device, scene, &renderer_desc, &renderer) &&
             !manylight_render(renderer, NULL) && !manylight_read(renderer, NULL, &image) &&
             !manylight_image_write(image, output);
    if (ok)
        ok = print_layer(image, "beauty") && print_layer(image, "direct") &&
             print_layer(image, "indirect");
    if (!ok)
        fprintf(stderr, "tiny: %s\n", manylight_error());
    manylight_image_free(image);
    manylight_renderer_free(renderer);
    manylight_scene_free(scene);
    manylight_device_free(device);
    return ok;
}

int main(int argc, char **argv) {
    if (argc != 3 && argc != 5) {
        fprintf(stderr, "usage: tiny SCENE.glb PICTURE.exr [WIDTH HEIGHT]\n");
        return 2;
    }
    manylight_log_to(tell, NULL);
    return run(argv[1], argv[2], argc == 5 ? atoi(argv[3]) : 0, argc == 5 ? atoi(argv[4]) : 0) ? 0
                                                                                               : 1;
}
