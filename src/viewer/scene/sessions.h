/* What is looked at and how, as sessions: shown, loaded, undone. */
#ifndef VIEWER_SESSIONS_H
#define VIEWER_SESSIONS_H

#include "viewer/state.h"

/* What is looked at and how; the texts are the session's. */
struct session viewer_session(const struct viewer *viewer);
bool viewer_load_session(struct viewer *viewer, const char *path);

/* Shows a session as it was: of the same scene. Error: a camera or a light is not understood. */
bool viewer_show_session(struct viewer *viewer, const struct session *session);

/* Notes where the user has come to, once nothing is on its way. */
void viewer_note_step(struct viewer *viewer);

/* One step back (-1) or forth again (1). */
void viewer_undo(struct viewer *viewer, int by);

#endif
