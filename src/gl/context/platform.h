/* Interface of a platform for context.c: lists candidates and creates contexts.
 *
 * A candidate is one way to a context: an EGL device, EGL surfaceless, OSMesa. context.c tries
 * candidates in order until one gives a context that meets gl/context/needs.h. */
#ifndef GL_CONTEXT_PLATFORM_H
#define GL_CONTEXT_PLATFORM_H

#include <stdbool.h>

enum { CANDIDATES_MAX = 64 };

struct candidate {
    const struct platform *platform;
    void *device;  /* EGLDeviceEXT; NULL for EGL surfaceless and OSMesa */
    int number;    /* number of the EGL device, from 0; -1 for others */
    int cuda;      /* number in CUDA's order; -1: none */
    bool software; /* known to be software before it is tried */
    char name[128];
};

struct candidate_list {
    struct candidate items[CANDIDATES_MAX];
    int count;
};

/* A context as the platform knows it. */
struct native_context {
    const struct platform *platform;
    void *handle;  /* EGLContext, OSMesaContext */
    void *surface; /* EGLDisplay; image of OSMesa */
};

struct platform {
    /* Appends candidates, best first. Error: the library cannot be opened or used. */
    bool (*list)(struct candidate_list *list);

    /* Creates an OpenGL 4.5 core context, not current. Error: the reason, without the candidate's
     * name. */
    bool (*create)(struct native_context *native, const struct candidate *candidate, bool debug);
    void (*destroy)(struct native_context *native); /* the context must not be current */

    bool (*bind)(const struct native_context *native);
    void (*unbind)(const struct native_context *native);

    /* Returns the address of a function of OpenGL. Valid after create. */
    void *(*getproc)(const char *name);
};

extern const struct platform egl_platform, osmesa_platform;

#endif
