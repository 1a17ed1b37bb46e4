/* Keeps steps for undo as whole sessions: camera, lights, settings and all else that a session
 * holds. */
#ifndef VIEWER_HISTORY_H
#define VIEWER_HISTORY_H

#include "viewer/scene/session.h"

enum { HISTORY_MAX = 100 };

struct history {
    struct session *steps; /* of one scene, oldest first */
    int count, now;        /* steps[now] is the current one */
};

/* Returns true if both are the same but for the picture's size and kept views. */
bool history_same(const struct session *a, const struct session *b);

/* Forgets all steps, because another scene is shown. Accepts a zeroed history. */
void history_forget(struct history *history);

/* Adds a session as a step, in place of steps that were undone. A session equal to the current
 * step adds none. */
void history_note(struct history *history, const struct session *session);

/* Moves to the previous (-1) or next (1) step and returns it. NULL: there is none. */
const struct session *history_step(struct history *history, int by);

/* Replaces the current step by the session that is shown, which may differ by rounding. */
void history_correct(struct history *history, const struct session *session);

#endif
