/* What all parts of the viewer ask and tell. */
#include "viewer/state.h"

#include "base/error.h"

#include <stdio.h>

bool viewer_is_scripted(const struct viewer *viewer) {
    return viewer->desc.frames > 0 || viewer->desc.screenshot;
}

void viewer_touch(struct viewer *viewer) {
    viewer->shown.dirty = true;
    viewer->shown.pace.last_motion = window_time();
}

void viewer_tell_error(struct viewer *viewer) {
    if (!viewer_is_scripted(viewer)) /* a script ends with the error, which is then printed */
        fprintf(stderr, "manylight: %s\n", error_get());
    messages_add(&viewer->host.messages, UI_ERROR, "%s", error_get());
}
