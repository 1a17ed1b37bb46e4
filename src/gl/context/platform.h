/* What context.c asks of a platform: which ways to a context there are, and to go one of them.
 *
 * A candidate is one such way: an EGL device, EGL surfaceless, OSMesa. context.c tries candidates
 * in order until one gives a context that has all that is needed (gl/context/needs.h).
 */
#ifndef GL_CONTEXT_PLATFORM_H
#define GL_CONTEXT_PLATFORM_H

#include <stdbool.h>

enum { CANDIDATES_MAX = 64 };

struct candidate {
    const struct platform *platform;
    void *device;  /* EGLDeviceEXT; NULL for EGL surfaceless and OSMesa */
    int number;    /* of the EGL device, from 0; -1 for the others */
    int cuda;      /* its number in CUDA's order; -1 = it has none */
    bool software; /* known to render on the CPU before it is tried */
    char name[128];
};

struct candidate_list {
    struct candidate items[CANDIDATES_MAX];
    int count;
};

/* A context in the platform's own terms. */
struct native_context {
    const struct platform *platform;
    void *handle;  /* EGLContext, OSMesaContext */
    void *surface; /* EGLDisplay; OSMesa's image */
};

struct platform {
    /* Appends its candidates, best first. Error: the library cannot be opened or used. */
    bool (*list)(struct candidate_list *list);

    /* An OpenGL 4.5 core context, not current. Error: the reason, without the candidate's name. */
    bool (*create)(struct native_context *native, const struct candidate *candidate, bool debug);
    void (*destroy)(struct native_context *native); /* not current */

    bool (*bind)(const struct native_context *native);
    void (*unbind)(const struct native_context *native);

    /* Valid after create. */
    void *(*getproc)(const char *name);
};

extern const struct platform egl_platform, osmesa_platform;

#endif
