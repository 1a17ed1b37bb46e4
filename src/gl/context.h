/* OpenGL 4.5 core contexts without a window: EGL on a device, EGL surfaceless, OSMesa.
 *
 * libEGL and libOSMesa are opened at run time; a machine needs only one of them. The functions of
 * the current context are in the table `gl` (gl/api.h), filled by the context's own getproc.
 */
#ifndef GL_CONTEXT_H
#define GL_CONTEXT_H

#include <stdbool.h>
#include <stddef.h>

enum context_kind {
    CONTEXT_AUTO,   /* hardware EGL devices, then EGL surfaceless, then OSMesa */
    CONTEXT_EGL,    /* hardware EGL devices, then EGL surfaceless */
    CONTEXT_OSMESA, /* software, one process-wide library */
};

extern const char
    *const context_kind_names[]; /* "auto", "egl", "osmesa", NULL: for option tables */

struct context_desc {
    enum context_kind kind;
    int device; /* EGL device number from 0 as context_list_devices counts; -1 = try all in order */
    bool debug; /* a debug context: every GL message is logged and counted */
};

struct context;

/* Makes a context and makes it current. Error: one message that says what was tried and why each
 * attempt failed. */
struct context *context_create(const struct context_desc *desc);
void context_free(struct context *context);
void context_make_current(struct context *context);

/* Makes a context object around one that is already current (a window's): fills `gl` through
 * getproc. */
struct context *context_adopt(void *(*getproc)(const char *name), bool debug);

/* "EGL device 0 (/dev/dri/card0)", "EGL surfaceless", "OSMesa", "window". */
const char *context_description(const struct context *context);

/* Whether the GL implementation renders on the CPU (llvmpipe, softpipe, swrast). */
bool context_is_software(const struct context *context);

/* GL debug messages of severity above notification since the context was made. */
int context_message_count(const struct context *context);

/* Prints the EGL devices that there are, one per line, into text. */
void context_list_devices(char *text, size_t size);

#endif
