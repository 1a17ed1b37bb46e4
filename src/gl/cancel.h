/* Ends a long frame early. While a thread watches, its draws, dispatches and parallel loops ask now and then whether the
 * frame is still wanted. Once it is not they do nothing, so that the frame ends soon; its picture is then worthless.
 *
 * Draws are queued, by GPUs by the thousand. Asking therefore waits for those before (glFinish): after so many draws as
 * take about a quarter of a second. Pictures keep their bits.
 */
#ifndef GL_CANCEL_H
#define GL_CANCEL_H

#include <stdbool.h>

/* True: the frame is not wanted. */
typedef bool cancel_ask(void *user);

/* Watches the draws of this thread's context, until cancel_end. interval: milliseconds from one question to the next. */
void cancel_begin(cancel_ask *ask, void *user, double interval);

/* Whether the frame was found to be not wanted, within a watch. */
bool cancel_came(void);

/* Ends the watch. True: what was drawn meanwhile is worthless. */
bool cancel_end(void);

enum { CANCEL_INTERVAL = 250 };

#endif
