#include "viewer/reference/comparing.h"

#include "base/memory.h"
#include "viewer/picture/picture.h"
#include "viewer/reference/tracing.h"
#include "viewer/scene/sessions.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Scene, camera, time, lights and sky as text. */
static char *view_text(const struct viewer *viewer) {
    struct session session = viewer_session(viewer);
    char *text = mem_printf("%s|%s|%.9g|%s|%s|%s|%.9g|%.9g", session.scene, session.clip,
                            (double)session.time, session.camera, session.lights,
                            session.sky ? session.sky : "", (double)session.sky_turn,
                            (double)session.sky_strength);
    session_free(&session);
    return text;
}

void viewer_note_reference_view(struct viewer *viewer) {
    struct shown *shown = &viewer->shown;
    const float *pixels = shown->compare.reference.picture.pixels;
    if (shown->compare.mode != COMPARE_REFERENCE || !shown->compare.measured ||
        pixels == shown->reference_pixels)
        return;
    free(shown->reference_view);
    shown->reference_view = view_text(viewer);
    shown->reference_pixels = pixels;
}

bool viewer_reference_fits(const struct viewer *viewer) {
    const struct shown *shown = &viewer->shown;
    if (!shown->reference_view || !viewer->has_scene)
        return true;
    char *now = view_text(viewer);
    bool fits = strcmp(now, shown->reference_view) == 0;
    free(now);
    return fits;
}

bool viewer_load_reference(struct viewer *viewer, const char *path) {
    struct shown *shown = &viewer->shown;
    struct compare *compare = &shown->compare;
    viewer_forget_reference(viewer);
    if (!reference_load(&compare->reference, path)) {
        viewer_tell_error(viewer);
        return false;
    }
    if (path != viewer->panel.reference_path)
        snprintf(viewer->panel.reference_path, sizeof viewer->panel.reference_path, "%s", path);
    viewer_compare_reference(viewer);
    return true;
}

/* Errors need pictures of one size. */
void viewer_compare_reference(struct viewer *viewer) {
    struct shown *shown = &viewer->shown;
    struct compare *compare = &shown->compare;
    compare->mode = COMPARE_REFERENCE;
    compare->measured = false;
    if (compare->reference.framebuffer) {
        shown->fixed_width = compare->reference.picture.width;
        shown->fixed_height = compare->reference.picture.height;
    }
    shown->dirty = true;
}

void viewer_fill_window(struct viewer *viewer) {
    struct shown *shown = &viewer->shown;
    if (shown->compare.mode == COMPARE_REFERENCE)
        shown->compare.mode = COMPARE_OFF;
    shown->fixed_width = shown->fixed_height = 0;
    shown->dirty = true;
}

bool viewer_has_reference_size(const struct viewer *viewer) {
    const struct image *reference = &viewer->shown.compare.reference.picture;
    int width, height;
    viewer_full_size(viewer, &width, &height);
    return reference->width == width && reference->height == height;
}
