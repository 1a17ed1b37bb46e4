/* Writes what is shown to files. */
#include "viewer/viewer.h"

#include "base/file/image_file.h"
#include "viewer/window/ui.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

/* The right picture right of the split, as glsl/inspect/screen.frag has it. */
static void paste_right(struct bitmap *shown, const struct screen_pictures *pictures) {
    struct bitmap right;
    texture_read_bitmap(pictures->right, &right);
    for (int y = 0; y < shown->height; y++)
        for (int x = 0; x < shown->width; x++)
            if (((float)x + .5F) / (float)shown->width >= pictures->split)
                memcpy(shown->rgba + 4 * ((size_t)y * (size_t)shown->width + (size_t)x),
                       right.rgba + 4 * ((size_t)y * (size_t)shown->width + (size_t)x), 4);
    bitmap_free(&right);
}

void viewer_read_shown(const struct viewer *viewer, struct bitmap *shown) {
    struct screen_pictures pictures = viewer_pictures(viewer);
    const struct texture *left = pictures.left, *right = pictures.right;
    texture_read_bitmap(left, shown);
    if (right && right->desc.width == shown->width && right->desc.height == shown->height)
        paste_right(shown, &pictures);
}

bool viewer_write_picture(struct viewer *viewer, const char *path) {
    bool is_float, ok;
    if (!image_format_is_float(path, &is_float) ||
        !scene_check_output(viewer->shown.renderer.desc.scene, path))
        return false;
    if (is_float) {
        struct image image = {0};
        ok = renderer_read_layers(&viewer->shown.renderer, &image) && image_write(&image, path);
        image_free(&image);
    } else {
        struct bitmap bitmap;
        viewer_read_shown(viewer, &bitmap);
        ok = bitmap_write(&bitmap, path);
        bitmap_free(&bitmap);
    }
    return ok;
}

void viewer_take_screenshot(struct viewer *viewer) {
    if (!viewer->has_scene)
        return;
    char png[64], exr[64];
    viewer->shown.moving = false; /* in the full size, whatever is on its way */
    viewer->shown.pace.last_motion = 0;
    viewer->shown.busy = ""; /* at once, without a sign before it */
    bool ok = viewer_update_picture(viewer);
    viewer->shown.busy = NULL;
    if (!ok) {
        viewer_tell_error(viewer);
        viewer_close_scene(viewer);
        return;
    }
    for (int i = 1; i < 10000; i++) {
        snprintf(png, sizeof png, "manylight-%04d.png", i);
        snprintf(exr, sizeof exr, "manylight-%04d.exr", i);
        if (access(png, F_OK) != 0 && access(exr, F_OK) != 0)
            break;
    }
    if (viewer_write_picture(viewer, png) && viewer_write_picture(viewer, exr))
        messages_add(&viewer->host.messages, UI_NORMAL, "written: %s, and %s with all layers", png,
                     exr);
    else
        viewer_tell_error(viewer);
}
