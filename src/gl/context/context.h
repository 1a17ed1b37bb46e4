/* OpenGL 4.5 core contexts without a window: EGL on a device, EGL surfaceless, OSMesa.
 *
 * libEGL and libOSMesa are opened at run time; a machine needs only one of them. The functions of
 * the current context are in the table `gl` (gl/api.h), filled by the context's own getproc.
 */
#ifndef GL_CONTEXT_CONTEXT_H
#define GL_CONTEXT_CONTEXT_H

#include <stdbool.h>
#include <stddef.h>

enum context_kind {
    CONTEXT_AUTO,   /* EGL, then OSMesa */
    CONTEXT_EGL,    /* hardware devices, then surfaceless, then software devices */
    CONTEXT_OSMESA, /* software, one process-wide library */
};

/* For option tables: "auto", "egl", "osmesa", NULL. */
extern const char *const context_kind_names[];

struct context_desc {
    enum context_kind kind;
    /* The only device to be tried: "2" by EGL's number, "cuda:2" by CUDA's, "hardware" = the first that is no software.
     * NULL = all in order. */
    const char *device;
    bool debug; /* a debug context: GL's messages are logged and counted */
    bool
        embedded; /* in a process of others, whose allocator and environment variables stay as they are */
    int screen; /* how screen passes run, of the whole process: an enum screen_way (gl/screen.h); 0 = as chosen */
};

/* Whether a text is such a device. Error: says how devices are named. */
bool context_check_device(const char *text);

struct context;
struct program_store; /* gl/program.h */

/* Makes a context and makes it current. A warning says why hardware that is there is not used. Error: one message that
 * says what was tried and why each attempt failed; the context that was current still is. */
struct context *context_create(const struct context_desc *desc);

/* Accepts NULL. The freed context is current no more; another one that is current stays so. */
void context_free(struct context *context);

/* Lets the thread's present context go and makes this one current: the table `gl` is its own. NULL: none.
 * A window's context is bound by its owner, after this call. */
void context_make_current(struct context *context);

/* The same. Error: the driver refuses, and no context is current. */
bool context_bind(struct context *context);

/* Programs that one context has linked others may take from the store: fills = it is that one. */
void context_set_store(struct context *context, struct program_store *store, bool fills);

/* Makes a context object around one that is already current (a window's): fills `gl` through
 * getproc. */
struct context *context_adopt(void *(*getproc)(const char *name), bool debug);

/* The same in a process of others (embedded). Its objects are deleted by context_delete_objects while it is current, before
 * context_free: the OpenGL context lives on. */
struct context *context_adopt_embedded(void *(*getproc)(const char *name));
void context_delete_objects(struct context *context);

/* Error: the driver has lost the current context, as when it resets the GPU; what was read back since is
 * no picture. EGL tells it where the driver does; a window's context is not asked to, as GLFW has that only
 * with checks of every access. */
bool context_check(void);

/* "EGL device 0 (/dev/dri/card0)", "EGL device 1 (software)", "EGL surfaceless", "OSMesa",
 * "window". */
const char *context_description(const struct context *context);

/* Faults since the context was made: GL debug messages of severity above notification but those of performance, and draws
 * with a sampler that has no texture. */
int context_message_count(const struct context *context);

/* All ways to a context that there are, one per line in the order tried, into text; then why
 * others are not. */
void context_list_devices(char *text, size_t size);

#endif
