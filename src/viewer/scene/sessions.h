/* Shows, saves, loads and undoes sessions. */
#ifndef VIEWER_SESSIONS_H
#define VIEWER_SESSIONS_H

#include "viewer/state.h"

/* Returns the present session, which owns its texts. */
struct session viewer_session(const struct viewer *viewer);
bool viewer_load_session(struct viewer *viewer, const char *path);

/* Saves settings, camera and lights, and shows the path or the error. */
void viewer_save_session(struct viewer *viewer);

/* Shows a session of the same scene. Error: an invalid camera or light. */
bool viewer_show_session(struct viewer *viewer, const struct session *session);

/* Adds an undo step, once no change is in progress. */
void viewer_note_step(struct viewer *viewer);

/* Undoes (-1) or redoes (1) a step. */
void viewer_undo(struct viewer *viewer, int by);

#endif
