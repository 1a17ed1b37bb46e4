/* What was looked at and how, step by step, to be taken back: whole sessions, so that camera,
 * lights and settings, and whatever a session comes to hold, are taken back alike. */
#ifndef VIEWER_HISTORY_H
#define VIEWER_HISTORY_H

#include "viewer/scene/session.h"

enum { HISTORY_MAX = 100 };

struct history {
    struct session *steps; /* oldest first; of one scene */
    int count, now;        /* steps[now] is the present one */
};

/* Whether nothing was changed from one to the other; the picture's size and views that were kept
 * are no change. */
bool history_same(const struct session *a, const struct session *b);

/* Of another scene nothing can be taken back. Accepts zeroed ones. */
void history_forget(struct history *history);

/* Notes a session that is not the present one: a step that what had been taken back gives way to */
void history_note(struct history *history, const struct session *session);

/* The step before (-1) or after (1) the present one, which it then is; NULL = there is none. */
const struct session *history_step(struct history *history, int by);

/* What came of the present step when it was shown: it may be a rounding away. */
void history_correct(struct history *history, const struct session *session);

#endif
