#include "viewer/scene/history.h"

#include "base/memory.h"

#include <stdlib.h>
#include <string.h>

bool history_same(const struct session *a, const struct session *b) {
    struct setting setting = {0};
    while (settings_next(&a->settings, &setting))
        if (!setting_equal(&setting, &a->settings, &b->settings))
            return false;
    return a->technique == b->technique && a->direct == b->direct && a->passes == b->passes &&
           a->layer == b->layer && strcmp(a->clip, b->clip) == 0 && a->time == b->time &&
           strcmp(a->camera, b->camera) == 0 && strcmp(a->lights, b->lights) == 0 &&
           session_same_sky(a, b);
}

static void drop(struct history *history, int first, int count) {
    if (count == 0)
        return;
    for (int i = first; i < first + count; i++)
        session_free(&history->steps[i]);
    memmove(history->steps + first, history->steps + first + count,
            (size_t)(history->count - first - count) * sizeof *history->steps);
    history->count -= count;
}

void history_forget(struct history *history) {
    drop(history, 0, history->count);
    free(history->steps);
    *history = (struct history){0};
}

void history_note(struct history *history, const struct session *session) {
    if (history->count > 0 && history_same(&history->steps[history->now], session))
        return;
    if (history->count > 0)
        drop(history, history->now + 1, history->count - history->now - 1);
    if (history->count == HISTORY_MAX)
        drop(history, 0, 1);
    if (!history->steps)
        history->steps = mem_alloc(HISTORY_MAX, sizeof *history->steps);
    history->steps[history->count] = session_copy(session);
    history->now = history->count++;
}

const struct session *history_step(struct history *history, int by) {
    int to = history->now + by;
    if (to < 0 || to >= history->count)
        return NULL;
    history->now = to;
    return &history->steps[to];
}

void history_correct(struct history *history, const struct session *session) {
    struct session *step = &history->steps[history->now];
    session_free(step);
    *step = session_copy(session);
}
