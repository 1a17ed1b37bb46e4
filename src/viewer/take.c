/* What a file is that was dropped, typed or chosen. */
#include "viewer/viewer.h"

#include "base/file/folder.h"
#include "base/file/image_file.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

static bool ends_in(const char *path, const char *ending) {
    const char *dot = strrchr(path, '.');
    return dot && strcasecmp(dot, ending) == 0;
}

/* A picture of a view has layers, or depth, or tells its passes; no panorama has. */
static bool is_render(const struct image *image) {
    bool has = image->passes || image_find_channel(image, "Z") >= 0;
    for (int i = 0; i < image->channel_count; i++)
        has |= strchr(image->names[i], '.') != NULL;
    return has;
}

/* .hdr holds no layers, and is what panoramas come as. Error: the file cannot be read. */
static bool is_sky(const char *path, bool *is) {
    struct image image;
    if (!image_read(&image, path))
        return false;
    *is = image.width == 2 * image.height && !is_render(&image);
    image_free(&image);
    return true;
}

static void take_reference(struct viewer *viewer, const char *path) {
    if (viewer_load_reference(viewer, path))
        messages_add(&viewer->host.messages, UI_NORMAL,
                     "%s: the reference to compare with. As a sky: Light, sky.", path_name(path));
}

static void take_picture(struct viewer *viewer, const char *path) {
    bool sky;
    if (!is_sky(path, &sky))
        viewer_tell_error(viewer);
    else if (!sky)
        take_reference(viewer, path);
    else if (!viewer->has_scene)
        messages_add(&viewer->host.messages, UI_WARNING, "%s is a sky: open a scene, then its sky.",
                     path_name(path));
    else
        viewer_open_sky(viewer, path);
}

void viewer_take_file(struct viewer *viewer, const char *path) {
    char *whole = path_of_user(path);
    messages_forget_errors(&viewer->host.messages);
    if (ends_in(whole, ".settings"))
        viewer_load_session(viewer, whole);
    else if (ends_in(whole, ".hdr") || ends_in(whole, ".exr") || ends_in(whole, ".pfm"))
        take_picture(viewer, whole);
    else
        viewer_open(viewer, whole);
    free(whole);
}
