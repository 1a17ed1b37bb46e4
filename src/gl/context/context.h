/* OpenGL 4.5 core contexts without a window: EGL on a device, EGL surfaceless, OSMesa.
 *
 * libEGL and libOSMesa are opened at run time; a machine needs only one of them. The table `gl`
 * (gl/api.h) holds the functions of the current context, loaded by its own getproc. */
#ifndef GL_CONTEXT_CONTEXT_H
#define GL_CONTEXT_CONTEXT_H

#include <stdbool.h>
#include <stddef.h>

enum context_kind {
    CONTEXT_AUTO,   /* EGL, then OSMesa */
    CONTEXT_EGL,    /* hardware devices, then surfaceless, then software devices */
    CONTEXT_OSMESA, /* software, one process-wide library */
};

/* Names for option tables: "auto", "egl", "osmesa", NULL. */
extern const char *const context_kind_names[];

struct context_desc {
    enum context_kind kind;
    /* The only device to try: EGL's number "2", CUDA's number "cuda:2", or "hardware", the first
     * that is no software. NULL: all in order. */
    const char *device;
    bool debug; /* debug context: messages of OpenGL are logged and counted */
    /* True in a host process: its allocator and environment variables stay unchanged. */
    bool embedded;
    /* How screen passes of the process run: an enum screen_way (gl/screen.h); 0: as chosen. */
    int screen;
};

/* Checks the text of a device. Error: explains how devices are named. */
bool context_check_device(const char *text);

struct context;
struct program_store; /* gl/program.h */

/* Creates a context and makes it current. Warns with the reason if existing hardware is not used.
 * Error: one message names each attempt and why it failed; the previous context stays current. */
struct context *context_create(const struct context_desc *desc);

/* Frees the context and makes none current if it was current. Accepts NULL. */
void context_free(struct context *context);

/* Makes this context current on the thread and fills the table `gl`. NULL: none. The owner of a
 * window binds the window's context after this call. Aborts if the driver refuses. */
void context_make_current(struct context *context);

/* Makes this context current. Error: the driver refuses; no context is current then. */
bool context_bind(struct context *context);

/* Sets the context's program store. fills: the context adds its programs; others take programs from
 * the store. */
void context_set_store(struct context *context, struct program_store *store, bool fills);

/* Wraps an OpenGL context that is already current, such as a window's. getproc fills `gl`. */
struct context *context_adopt(void *(*getproc)(const char *name), bool debug);

/* Wraps a host's current context (`embedded`). Before context_free call context_delete_objects
 * while it is current: the OpenGL context lives on. */
struct context *context_adopt_embedded(void *(*getproc)(const char *name));
void context_delete_objects(struct context *context);

/* Checks that the driver still has the current context, which a reset of the GPU loses. Error: it
 * is lost; pictures read back after the loss are invalid. Contexts of a window report no loss: GLFW
 * would have to check every access. */
bool context_check(void);

/* Returns "EGL device 0 (/dev/dri/card0)", "EGL device 1 (software)", "EGL surfaceless", "OSMesa"
 * or "window". */
const char *context_description(const struct context *context);

/* Returns the number of faults of the context. Faults are debug messages above notification, except
 * on performance, and samplers of a draw without a texture or a unit of their own. */
int context_message_count(const struct context *context);

/* Writes all available devices into text, one per line in the order tried, then the reasons for the
 * others. */
void context_list_devices(char *text, size_t size);

#endif
