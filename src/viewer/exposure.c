/* How bright the picture is shown: by itself when a scene is opened, then as the user likes. */
#include "viewer/viewer.h"

#include "viewer/develop.h"

#include <math.h>

static void set(struct viewer *viewer, float exposure) {
    struct picture_settings *picture = settings_edit(&viewer->wish.settings, &picture_part);
    picture->exposure = fminf(fmaxf(exposure, -EXPOSURE_MOST), EXPOSURE_MOST);
    viewer_retone(viewer);
}

void viewer_expose(struct viewer *viewer, float by) {
    const struct picture_settings *picture = settings_of(&viewer->wish.settings, &picture_part);
    set(viewer, picture->exposure + by);
}

void viewer_reset_exposure(struct viewer *viewer) {
    set(viewer, viewer->exposing.usual);
}

void viewer_begin_exposure(struct viewer *viewer) {
    const struct picture_settings *picture = settings_of(&viewer->wish.settings, &picture_part);
    viewer->exposing.usual = picture->exposure;
    viewer->exposing.waits = viewer->desc.auto_exposure;
    viewer->exposing.after_frame = viewer->shown.frame_count;
}

/* By the first frame of the scene. */
void viewer_follow_exposure(struct viewer *viewer) {
    struct exposing *exposing = &viewer->exposing;
    struct image frame = {0};
    if (!exposing->waits || viewer->shown.frame_count == exposing->after_frame)
        return;
    exposing->waits = false;
    if (renderer_read_layers(&viewer->shown.renderer, &frame)) {
        exposing->usual = develop_exposure(&frame);
        set(viewer, exposing->usual);
    }
    image_free(&frame);
}
