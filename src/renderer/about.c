#include "renderer/about.h"

#include "base/primaries.h"
#include "base/text.h"
#include "renderer/settings.h"
#include "version.h"

#include <stdlib.h>
#include <string.h>

static const char *file_name(const char *path) {
    const char *slash = strrchr(path, '/');
    return slash ? slash + 1 : path;
}

/* "lights.vpls=512 blur.radius=3", or NULL; to be freed. */
static char *changed_settings(const struct settings *settings) {
    struct settings defaults;
    struct text text = {0};
    renderer_settings_init(&defaults);
    for (struct setting s = {0}; settings_next(&defaults, &s);) {
        char name[SETTING_NAME_SIZE], value[64];
        if (setting_equal(&s, settings, &defaults))
            continue;
        setting_name(&s, name);
        setting_format(&s, settings, value, sizeof value);
        text_print(&text, "%s%s=%s", text.length ? " " : "", name, value);
    }
    return text.data;
}

static void add_camera(struct image *image, const struct camera *camera) {
    float matrix[16];
    if (camera_is_wide(camera) || camera_is_distorted(camera))
        return;
    camera_world_to_camera(camera, matrix);
    image_add_numbers(image, "worldToCamera", IMAGE_MATRIX, matrix);
    camera_world_to_ndc(camera, (float)image->width / (float)image->height, matrix);
    image_add_numbers(image, "worldToNDC", IMAGE_MATRIX, matrix);
}

void about_add(struct image *image, const struct about *about) {
    const char *scene = file_name(about->scene), *camera = about->camera ? about->camera : "0";
    char *settings = changed_settings(about->settings);
    struct text comments = {0};
    text_print(&comments, "%s, camera %s, at %g s, by %s%s%s", scene, camera, about->time,
               about->technique, settings ? " with " : "", settings ? settings : "");
    image_add_text(image, "software", "manylight " MANYLIGHT_VERSION);
    image_add_text(image, "comments", comments.data);
    image_add_text(image, "manylight:scene", scene);
    image_add_text(image, "manylight:camera", camera);
    image_add_text(image, "manylight:technique", about->technique);
    image_add_text(image, "manylight:settings", settings ? settings : "");
    image_add_numbers(image, "manylight:time", IMAGE_NUMBER, &(float){(float)about->time});
    image_add_numbers(image, "chromaticities", IMAGE_CHROMATICITIES, primaries_bt709);
    add_camera(image, about->placed);
    mem_free(comments.data, settings);
}
