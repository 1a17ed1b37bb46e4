/* Where the renderer's OpenGL runs: a context of its own on a thread of its own, or the caller's. */
#ifndef LIBRARY_DEVICE_H
#define LIBRARY_DEVICE_H

#include "library/manylight.h"
#include "library/worker.h"

/* Error: another process used a device first, and this one was forked from it. */
bool device_is_at_home(void);

/* One more user of the device, and one less: the last one ends it. */
struct manylight_device *device_hold(struct manylight_device *device);
void device_release(struct manylight_device *device);

/* Runs the job while the device's context is current, and waits for it. Error: the job's, or one of its callbacks calls this,
 * or the host's context does not become current. */
bool device_do(struct manylight_device *device, worker_job *job, void *context);

/* Whether OpenGL of the caller, who can use its objects. */
bool device_is_adopted(const struct manylight_device *device);

#endif
