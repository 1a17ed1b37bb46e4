#define _POSIX_C_SOURCE 200809L
#include "library/device.h"

#include "base/error.h"
#include "base/memory.h"
#include "gl/api.h"
#include "gl/context/context.h"
#include "library/desc.h"
#include "library/door.h"

#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* Drivers and devices have threads, which a forked child lacks: its calls would wait for them for
 * ever. */
static _Atomic(pid_t) home; /* the process that used OpenGL first; 0: none */

bool device_is_at_home(void) {
    pid_t first = atomic_load(&home);
    if (first == 0 || first == getpid())
        return true;
    error_set("this process was forked after process %d had used a device: start processes by "
              "spawn, or use no device before the fork",
              (int)first);
    return door_blame(MANYLIGHT_NO_DEVICE);
}

/* Before the first call of a driver. */
static bool settle(void) {
    pid_t none = 0;
    atomic_compare_exchange_strong(&home, &none, getpid());
    return device_is_at_home();
}

struct manylight_device {
    atomic_int users;
    bool adopted;
    struct worker worker; /* own devices: all that follows is for its thread */
    struct context *context;
    struct manylight_device_info info;
    /* Adopted devices. */
    struct manylight_host host;
    pthread_mutex_t busy;
    atomic_bool is_busy;
    _Atomic(pthread_t) user; /* while is_busy */
};

/* --- the caller's context --------------------------------------------------------------------- */

/* OpenGL's loaders take no user pointer. */
static _Thread_local const struct manylight_host *asked;

static void *ask(const char *name) {
    return asked->get_proc(asked->user, name);
}

static bool enter_host(struct manylight_device *device) {
    if (atomic_load(&device->is_busy) &&
        pthread_equal(atomic_load(&device->user), pthread_self())) {
        error_set("the device is at work: a callback cannot call it");
        return door_blame(MANYLIGHT_BAD_ARGUMENT);
    }
    pthread_mutex_lock(&device->busy);
    if (device->host.make_current && device->host.make_current(device->host.user) != 0) {
        pthread_mutex_unlock(&device->busy);
        error_set("the host's make_current failed");
        return door_blame(MANYLIGHT_NO_DEVICE);
    }
    atomic_store(&device->user, pthread_self());
    atomic_store(&device->is_busy, true);
    return true;
}

static void leave_host(struct manylight_device *device) {
    if (device->host.release_current)
        device->host.release_current(device->host.user);
    atomic_store(&device->is_busy, false);
    pthread_mutex_unlock(&device->busy);
}

static bool do_in_host(struct manylight_device *device, worker_job *job, void *context) {
    if (!enter_host(device))
        return false;
    bool ok = context_bind(device->context) && job(context);
    context_bind(NULL);
    leave_host(device);
    return ok;
}

/* --- making one ------------------------------------------------------------------------------- */

static void describe(struct manylight_device *device) {
    struct manylight_device_info *info = &device->info;
    const struct {
        char *to;
        GLenum name;
    } rows[] = {
        {info->vendor, GL_VENDOR}, {info->renderer, GL_RENDERER}, {info->version, GL_VERSION}};
    snprintf(info->name, sizeof info->name, "%s", context_description(device->context));
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        snprintf(rows[i].to, sizeof info->vendor, "%s", (const char *)gl.GetString(rows[i].name));
    info->software = gl.software;
    info->memory = gl.memory;
}

struct opening {
    struct manylight_device *device;
    const struct manylight_device_desc *desc;
};

static bool refuse_software(struct manylight_device *device) {
    error_set("%s: it is software, which allow_software takes", device->info.name);
    context_free(device->context);
    device->context = NULL;
    return false;
}

/* On the device's thread. Without a wish for one device, hardware alone is tried where software is
 * not allowed. */
static bool open_own(void *user) {
    struct opening *opening = user;
    const struct manylight_device_desc *desc = opening->desc;
    struct manylight_device *device = opening->device;
    bool any_hardware = !desc->device && !desc->allow_software;
    device->context =
        context_create(&(struct context_desc){.kind = CONTEXT_AUTO,
                                              .device = any_hardware ? "hardware" : desc->device,
                                              .debug = desc->debug != 0,
                                              .embedded = true});
    if (!device->context)
        return any_hardware && error_prefix("no hardware (allow_software is off)");
    describe(device);
    return desc->allow_software || !device->info.software || refuse_software(device);
}

static bool open_adopted(struct manylight_device *device) {
    if (!enter_host(device))
        return false;
    asked = &device->host;
    device->context = context_adopt_embedded(ask);
    if (device->context)
        describe(device);
    context_bind(NULL);
    leave_host(device);
    return device->context != NULL;
}

static bool open_device(struct manylight_device *device, const struct manylight_device_desc *desc) {
    if (device->adopted) {
        if (device->host.get_proc)
            return open_adopted(device);
        error_set("host: get_proc is NULL");
        return door_blame(MANYLIGHT_BAD_ARGUMENT);
    }
    if (!worker_start(&device->worker))
        return false;
    if (worker_do(&device->worker, open_own, &(struct opening){device, desc}))
        return true;
    worker_stop(&device->worker);
    return false;
}

static void free_struct(struct manylight_device *device) {
    pthread_mutex_destroy(&device->busy);
    free(device);
}

static bool create(const struct manylight_device_desc *given, struct manylight_device **out) {
    struct manylight_device_desc desc;
    struct manylight_host host;
    if (!desc_take(&desc, sizeof desc, given, "manylight_device_desc") ||
        !desc_take(&host, sizeof host, desc.host, "manylight_host"))
        return false;
    struct manylight_device *device = mem_alloc(1, sizeof *device);
    atomic_init(&device->users, 1);
    pthread_mutex_init(&device->busy, NULL);
    device->adopted = desc.host != NULL;
    device->host = host;
    if (!open_device(device, &desc)) {
        free_struct(device);
        return false;
    }
    *out = device;
    return true;
}

enum manylight_status manylight_device_create(const struct manylight_device_desc *desc,
                                              struct manylight_device **device) {
    struct door door;
    *device = NULL;
    door_enter(&door);
    return door_leave(&door, settle() && create(desc, device), MANYLIGHT_NO_DEVICE);
}

/* --- being used ------------------------------------------------------------------------------- */

bool device_is_adopted(const struct manylight_device *device) {
    return device->adopted;
}

bool device_do(struct manylight_device *device, worker_job *job, void *context) {
    if (!device_is_at_home())
        return false;
    if (device->adopted)
        return do_in_host(device, job, context);
    if (!worker_is_self(&device->worker))
        return worker_do(&device->worker, job, context);
    error_set("the device is at work: a callback cannot call it");
    return door_blame(MANYLIGHT_BAD_ARGUMENT);
}

struct manylight_device *device_hold(struct manylight_device *device) {
    atomic_fetch_add(&device->users, 1);
    return device;
}

static bool close_context(void *user) {
    struct manylight_device *device = user;
    if (device->adopted)
        context_delete_objects(device->context);
    context_free(device->context);
    return true;
}

void device_release(struct manylight_device *device) {
    if (!device || !device_is_at_home() || atomic_fetch_sub(&device->users, 1) > 1)
        return;
    device_do(device, close_context, device);
    if (!device->adopted)
        worker_stop(&device->worker);
    free_struct(device);
}

void manylight_device_free(struct manylight_device *device) {
    struct door door;
    door_enter(&door);
    device_release(device);
    door_leave(&door, true, MANYLIGHT_OK);
}

enum manylight_status manylight_device_info(struct manylight_device *device,
                                            struct manylight_device_info *info) {
    struct door door;
    door_enter(&door);
    bool ok = device_is_at_home() &&
              desc_give(info, &device->info, sizeof device->info, "manylight_device_info");
    return door_leave(&door, ok, MANYLIGHT_BAD_ARGUMENT);
}

void manylight_list_devices(char *text, size_t text_size) {
    struct door door;
    door_enter(&door);
    if (text_size > 0 && settle())
        context_list_devices(text, text_size);
    else if (text_size > 0)
        snprintf(text, text_size, "%s", error_get());
    door_leave(&door, true, MANYLIGHT_OK);
}
