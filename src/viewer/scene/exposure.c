#include "viewer/scene/exposure.h"

#include "passes/frame.h"
#include "scene/animation.h"
#include "viewer/picture/picture.h"
#include "viewer/scene/animation.h"
#include "viewer/scene/develop.h"

#include <math.h>

static void set(struct viewer *viewer, float exposure) {
    struct settings *settings = &viewer->wish.settings;
    struct picture_settings picture =
        *settings_of(struct picture_settings, settings, &picture_part);
    picture.exposure = fminf(fmaxf(exposure, -EXPOSURE_MOST), EXPOSURE_MOST);
    settings_set(settings, &picture_part, &picture);
    viewer_retone(viewer);
}

void viewer_expose(struct viewer *viewer, float by) {
    const struct picture_settings *picture =
        settings_of(struct picture_settings, &viewer->wish.settings, &picture_part);
    set(viewer, picture->exposure + by);
}

void viewer_reset_exposure(struct viewer *viewer) {
    set(viewer, viewer->exposing.usual);
}

void viewer_begin_exposure(struct viewer *viewer) {
    const struct picture_settings *picture =
        settings_of(struct picture_settings, &viewer->wish.settings, &picture_part);
    viewer->exposing.usual = picture->exposure;
    viewer->exposing.waits = viewer->desc.auto_exposure;
    viewer->exposing.after_frame = viewer->shown.frame_count;
}

/* Where nearly nothing is seen as the scene begins, as behind a door that is shut, what leaks past
 * it is not to be exposed: then the middle of its clip is shown. Whether it was. */
static bool skip_darkness(struct viewer *viewer, const struct image *picture) {
    static const double dark = 1e-2; /* over what the lights would give across the scene */
    struct frame frame = renderer_frame(&viewer->shown.renderer);
    double duration = scene_duration(&viewer->document.scene);
    bool is_dark = develop_highlight(picture) * (double)frame.irradiance_scale < dark;
    if (!is_dark || duration <= 0 || viewer->placed.time != 0)
        return false;
    viewer_go_to(viewer, duration / 2);
    messages_add(&viewer->host.messages, UI_NORMAL, "It is dark at 0 s: this is %g s.",
                 viewer->placed.time);
    return true;
}

/* By the first frame of the scene. */
void viewer_follow_exposure(struct viewer *viewer) {
    struct exposing *exposing = &viewer->exposing;
    struct image frame = {0};
    if (!exposing->waits || viewer->shown.frame_count == exposing->after_frame)
        return;
    exposing->waits = false;
    if (renderer_read_layers(&viewer->shown.renderer, &frame)) {
        if (skip_darkness(viewer, &frame)) {
            exposing->waits = true;
            exposing->after_frame = viewer->shown.frame_count;
            image_free(&frame);
            return;
        }
        exposing->usual = develop_exposure(&frame);
        set(viewer, exposing->usual);
    }
    image_free(&frame);
}
