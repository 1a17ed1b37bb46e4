/* Ends a long frame early. While a thread watches, its draws, dispatches and parallel loops call a
 * callback at intervals. After the callback cancels they do nothing, so the frame ends soon and its
 * picture is invalid.
 *
 * GPUs queue thousands of draws. Before each call the watch therefore waits for the queued draws
 * (glFinish). It calls after as many draws as take about a quarter of the interval. Pictures that
 * are not cancelled keep their bits. */
#ifndef GL_CANCEL_H
#define GL_CANCEL_H

#include <stdbool.h>

/* Returns true to cancel the frame. */
typedef bool cancel_ask(void *user);

/* Watches this thread's draws until cancel_end. interval: milliseconds between two questions. */
void cancel_begin(cancel_ask *ask, void *user, double interval);

/* True if the frame was cancelled, within a watch. */
bool cancel_came(void);

/* Ends the watch. Returns true if the frame was cancelled; its picture is then invalid. */
bool cancel_end(void);

enum { CANCEL_INTERVAL = 250 }; /* milliseconds */

#endif
