/* Takes steps back: of the camera, the lights, the settings. */
#include "viewer/viewer.h"

#include <string.h>

/* While something is dragged, typed, played or flown through there is no step yet. */
static bool is_settled(const struct viewer *viewer) {
    const struct input *input = viewer->host.input;
    for (int i = 0; i < BUTTON_COUNT; i++)
        if (input->held[i])
            return false;
    return viewer->has_scene && !viewer->shown.moving && !viewer->shown.dirty &&
           !viewer->wish.play.on && !viewer_is_scripted(viewer);
}

static void note(struct viewer *viewer) {
    struct session session = viewer_session(viewer);
    history_note(&viewer->history, &session);
    session_free(&session);
}

void viewer_note_step(struct viewer *viewer) {
    if (is_settled(viewer))
        note(viewer);
}

void viewer_undo(struct viewer *viewer, int by) {
    if (!viewer->has_scene)
        return;
    note(viewer);
    const struct session *step = history_step(&viewer->history, by);
    if (!step) {
        messages_add(&viewer->host.messages, UI_NORMAL,
                     by < 0 ? "Nothing to undo." : "Nothing to redo.");
        return;
    }
    struct session taken = *step;
    memcpy(taken.views, viewer->placed.views, sizeof taken.views); /* what was kept stays */
    if (!viewer_show_session(viewer, &taken))
        viewer_tell_error(viewer);
    struct session shown = viewer_session(viewer);
    history_correct(&viewer->history, &shown);
    session_free(&shown);
}
