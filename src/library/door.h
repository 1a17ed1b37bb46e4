/* Begin and end of every library function: state of the calling thread, errors, log. */
#ifndef LIBRARY_DOOR_H
#define LIBRARY_DOOR_H

#include "base/log.h"
#include "library/manylight.h"

#include <fenv.h>
#include <pthread.h>
#include <stdbool.h>

/* Saved state of one call, on its stack. */
struct door {
    struct log_sink sink; /* first member: log functions receive its address */
    const struct log_sink *sink_before;
    pthread_mutex_t telling; /* serialises messages of all threads */
    manylight_log *log;
    void *user;
    enum manylight_status blamed_before;
    void *locale_before; /* locale_t */
    fenv_t rounding_before;
};

/* Gives the thread the C locale, the default rounding mode and the log of manylight_log_to. */
void door_enter(struct door *door);

/* Restores the thread's state and returns the status: MANYLIGHT_OK if ok. Otherwise the status of
 * door_blame, MANYLIGHT_NO_MEMORY if memory was short, or `failure`. Keeps status and error for
 * manylight_error. */
enum manylight_status door_leave(struct door *door, bool ok, enum manylight_status failure);

/* Sets the status of the current failure, unless one is set. Returns false, for `return parse(...)
 * || door_blame(MANYLIGHT_BAD_SETTING)`. */
bool door_blame(enum manylight_status status);

/* Returns the status of door_blame in this call; MANYLIGHT_OK: none. */
enum manylight_status door_blamed(void);

#endif
