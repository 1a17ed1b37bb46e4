/* Views of a scene that are kept, to come back to. */
#include "viewer/viewer.h"

#include "scene/placing.h"

#include <string.h>

int views_free(const struct viewer *viewer) {
    int i = 0;
    while (i < SESSION_VIEWS - 1 && *viewer->placed.views[i])
        i++;
    return i;
}

void views_keep(struct viewer *viewer, int i) {
    struct placed *placed = &viewer->placed;
    if (!viewer->has_scene)
        return;
    camera_to_text(&placed->orbit.camera, &viewer->document.scene, placed->camera_number,
                   placed->time, placed->views[i]);
    messages_add(&viewer->host.messages, UI_NORMAL, "view %d kept: Alt %d goes there", i + 1,
                 i + 1);
}

void views_go(struct viewer *viewer, int i) {
    const char *text = viewer->placed.views[i];
    if (!viewer->has_scene)
        return;
    if (!*text)
        messages_add(&viewer->host.messages, UI_NORMAL, "no view %d yet: Ctrl %d keeps one", i + 1,
                     i + 1);
    else if (!viewer_place_camera(viewer, text))
        viewer_tell_error(viewer);
}
