#define _XOPEN_SOURCE 700
#include "viewer/files/screenshot.h"

#include "base/error.h"
#include "base/file/image_file.h"
#include "base/memory.h"
#include "viewer/picture/picture.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* The right picture right of the split, or the difference, as src/inspect/screen.frag has them. */
static void paste_right(struct bitmap *shown, const struct bitmap *right,
                        const struct screen_pictures *pictures) {
    for (int y = 0; y < shown->height; y++)
        for (int x = 0; x < shown->width; x++) {
            size_t at = 4 * ((size_t)y * (size_t)shown->width + (size_t)x);
            bool is_right = ((float)x + .5F) / (float)shown->width >= pictures->split;
            if (pictures->layout == SCREEN_WIPE && is_right)
                memcpy(shown->rgba + at, right->rgba + at, 4);
            for (int c = 0; c < 3 && pictures->layout == SCREEN_DIFFERENCE; c++) {
                int apart = 4 * abs(shown->rgba[at + (size_t)c] - right->rgba[at + (size_t)c]);
                shown->rgba[at + (size_t)c] = (unsigned char)(apart < 255 ? apart : 255);
            }
        }
}

static void paste_beside(struct bitmap *shown, const struct bitmap *right) {
    size_t row = 4 * (size_t)shown->width, height = (size_t)shown->height;
    unsigned char *both = mem_alloc(2 * row * height, 1);
    for (size_t y = 0; y < height; y++) {
        memcpy(both + 2 * row * y, shown->rgba + row * y, row);
        memcpy(both + 2 * row * y + row, right->rgba + row * y, row);
    }
    free(shown->rgba);
    shown->rgba = both;
    shown->width *= 2;
}

static void read_shown(const struct viewer *viewer, struct bitmap *shown) {
    struct screen_pictures pictures = viewer_pictures(viewer);
    const struct shown *all = &viewer->shown;
    const struct heat_map *light = inspect_light(&all->inspect, &all->choice);
    struct bitmap right;
    texture_read_bitmap(pictures.left, shown);
    if (light)
        heat_map_add_scale(light, shown);
    if (!pictures.right)
        return;
    texture_read_bitmap(pictures.right, &right);
    bool alike = right.width == shown->width && right.height == shown->height;
    if (alike && pictures.layout == SCREEN_BESIDE)
        paste_beside(shown, &right);
    else if (alike)
        paste_right(shown, &right, &pictures);
    bitmap_free(&right);
}

bool viewer_write_picture(struct viewer *viewer, const char *path) {
    bool is_float, ok;
    if (!image_format_is_float(path, &is_float) ||
        !scene_check_output(viewer->shown.renderer.desc.scene, path))
        return false;
    if (is_float) {
        struct image image = {0};
        ok = renderer_read_layers(&viewer->shown.renderer, &image) &&
             image_write_layer(&image, path, shown_layer_prefix(viewer->shown.layer));
        image_free(&image);
    } else {
        struct bitmap bitmap;
        read_shown(viewer, &bitmap);
        ok = bitmap_write(&bitmap, path);
        bitmap_free(&bitmap);
    }
    return ok;
}

int free_number(enum name_state (*state_of)(void *user, int number), void *user) {
    for (int number = 1; number <= FREE_NUMBER_MOST; number++) {
        enum name_state state = state_of(user, number);
        if (state != NAME_IS_TAKEN)
            return state == NAME_IS_FREE ? number : 0;
    }
    error_set("all numbers up to %d are taken in this folder: move files out of it",
              FREE_NUMBER_MOST);
    return 0;
}

/* Files that share a number. */
struct numbered {
    const char *stem, *endings[2]; /* the second ending: NULL where there is one file */
    char paths[2][64];
};

static enum name_state state_of(void *user, int number) {
    struct numbered *files = user;
    bool taken = false;
    for (int i = 0; i < 2 && files->endings[i]; i++) {
        snprintf(files->paths[i], sizeof files->paths[i], "%s-%04d%s", files->stem, number,
                 files->endings[i]);
        taken |= access(files->paths[i], F_OK) == 0;
    }
    return taken ? NAME_IS_TAKEN : NAME_IS_FREE;
}

void viewer_save_reference(struct viewer *viewer) {
    struct numbered files = {.stem = "manylight-reference", .endings = {".exr"}};
    const char *name = files.paths[0];
    if (!free_number(state_of, &files) ||
        !image_write(&viewer->shown.compare.reference.picture, name)) {
        viewer_tell_error(viewer);
        return;
    }
    char *path = realpath(name, NULL);
    messages_add_result(&viewer->host.messages, "written: %s, %d samples a pixel",
                        path ? path : name, viewer->tracing.samples);
    free(path);
}

bool viewer_take_screenshot(struct viewer *viewer) {
    if (!viewer->has_scene)
        return true;
    struct numbered files = {.stem = "manylight", .endings = {".png", ".exr"}};
    const char *png = files.paths[0], *exr = files.paths[1];
    viewer->shown.moving = false; /* in the full size, whatever is on its way */
    viewer->shown.pace.last_motion = 0;
    viewer->shown.busy = ""; /* at once, without a sign before it */
    bool ok = viewer_update_picture(viewer);
    viewer->shown.busy = NULL;
    if (!ok)
        return false;
    char *folder = realpath(".", NULL);
    if (free_number(state_of, &files) && viewer_write_picture(viewer, png) &&
        viewer_write_picture(viewer, exr))
        messages_add_result(&viewer->host.messages, "written to %s: %s, and %s with all layers",
                            folder ? folder : ".", png, exr);
    else
        viewer_tell_error(viewer);
    free(folder);
    return true;
}
