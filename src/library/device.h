/* Devices: an own context on an own thread, or the caller's context. */
#ifndef LIBRARY_DEVICE_H
#define LIBRARY_DEVICE_H

#include "library/manylight.h"
#include "library/worker.h"

/* Returns whether this process may use devices. Error: it was forked after its parent had used
 * one. */
bool device_is_at_home(void);

/* Adds or removes a user of the device. Removing the last user frees it. */
struct manylight_device *device_hold(struct manylight_device *device);
void device_release(struct manylight_device *device);

/* Runs the job with the device's context current, and waits for it. Error: that of the job; a
 * callback of the device calls this; or the host's context does not become current. */
bool device_do(struct manylight_device *device, worker_job *job, void *context);

/* True if the context is the caller's; the caller can then use the renderer's OpenGL objects. */
bool device_is_adopted(const struct manylight_device *device);

#endif
