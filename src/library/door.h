/* What every function of the library does at its beginning and its end: the state of the calling thread, errors, the log. */
#ifndef LIBRARY_DOOR_H
#define LIBRARY_DOOR_H

#include "base/log.h"
#include "library/manylight.h"

#include <fenv.h>
#include <pthread.h>
#include <stdbool.h>

/* Lives on the stack of one call. */
struct door {
    struct log_sink sink; /* first: the log's functions get it */
    const struct log_sink *sink_before;
    pthread_mutex_t telling; /* one message at a time, from whatever thread */
    manylight_log *log;
    void *user;
    enum manylight_status blamed_before;
    void *locale_before; /* a locale_t */
    fenv_t rounding_before;
};

/* From here on the thread has the C locale, the default rounding mode, and the log of manylight_log_to. */
void door_enter(struct door *door);

/* Puts back what was there. The status: success, or failure unless door_blame told another one, or memory was short; it
 * and the error are then kept for manylight_error. */
enum manylight_status door_leave(struct door *door, bool ok, enum manylight_status failure);

/* What the failure is at hand: `return parse(...) || door_blame(MANYLIGHT_BAD_SETTING)`. Always returns false. */
bool door_blame(enum manylight_status status);

/* MANYLIGHT_OK: nothing was blamed in this call. */
enum manylight_status door_blamed(void);

#endif
