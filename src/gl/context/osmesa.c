/* OSMesa: Mesa's software rasteriser as a plain library (gone from Mesa 25.1 on).
 *
 * Its header is seldom installed, so the few declarations are written out here. */
#include "gl/context/platform.h"

#include "base/error.h"
#include "base/memory.h"

#include <GL/glcorearb.h>

#include <dlfcn.h>
#include <string.h>

enum {
    OSMESA_FORMAT = 0x22,
    OSMESA_RGBA = GL_RGBA,
    OSMESA_PROFILE = 0x33,
    OSMESA_CORE_PROFILE = 0x34,
    OSMESA_CONTEXT_MAJOR_VERSION = 0x36,
    OSMESA_CONTEXT_MINOR_VERSION = 0x37,
};

typedef void (*osmesa_proc)(void);

/* Opened once and never closed: the library keeps per-thread state. */
static struct {
    void *library;
    void *(*CreateContextAttribs)(const int *attributes, void *share);
    void (*DestroyContext)(void *context);
    GLboolean (*MakeCurrent)(void *context, void *image, GLenum type, GLsizei width,
                             GLsizei height);
    osmesa_proc (*GetProcAddress)(const char *name);
} osmesa;

static bool find(const char *name, void *function) {
    void *found = dlsym(osmesa.library, name);
    memcpy(function, &found, sizeof found);
    return found || error_set("libOSMesa has no %s", name);
}

static bool open_library(void) {
    static const char *const names[] = {"libOSMesa.so.8", "libOSMesa.so"};
    for (int i = 0; i < 2 && !osmesa.library; i++)
        osmesa.library = dlopen(names[i], RTLD_NOW | RTLD_LOCAL);
    if (!osmesa.library)
        return error_set("cannot open %s", names[0]);
    return find("OSMesaCreateContextAttribs", &osmesa.CreateContextAttribs) &&
           find("OSMesaDestroyContext", &osmesa.DestroyContext) &&
           find("OSMesaMakeCurrent", &osmesa.MakeCurrent) &&
           find("OSMesaGetProcAddress", &osmesa.GetProcAddress);
}

static bool list(struct candidate_list *list) {
    if (!open_library())
        return error_prefix("OSMesa");
    if (list->count < CANDIDATES_MAX)
        list->items[list->count++] = (struct candidate){.platform = &osmesa_platform,
                                                        .number = -1,
                                                        .cuda = -1,
                                                        .software = true,
                                                        .name = "OSMesa"};
    return true;
}

/* OSMesa has no debug contexts; GL_DEBUG_OUTPUT works all the same. */
static bool create(struct native_context *native, const struct candidate *candidate, bool debug) {
    (void)candidate, (void)debug;
    static const int attributes[] = {OSMESA_FORMAT,
                                     OSMESA_RGBA,
                                     OSMESA_PROFILE,
                                     OSMESA_CORE_PROFILE,
                                     OSMESA_CONTEXT_MAJOR_VERSION,
                                     4,
                                     OSMESA_CONTEXT_MINOR_VERSION,
                                     5,
                                     0};
    void *handle = osmesa.CreateContextAttribs(attributes, NULL);
    if (!handle)
        return error_set("gives no OpenGL 4.5 core context");
    /* The one pixel of the default framebuffer. */
    *native = (struct native_context){&osmesa_platform, handle, mem_alloc(1, 4)};
    return true;
}

static void destroy(struct native_context *native) {
    osmesa.DestroyContext(native->handle);
    free(native->surface);
}

static bool bind(const struct native_context *native) {
    return osmesa.MakeCurrent(native->handle, native->surface, GL_UNSIGNED_BYTE, 1, 1) ||
           error_set("OSMesaMakeCurrent failed");
}

static void unbind(const struct native_context *native) {
    (void)native;
    osmesa.MakeCurrent(NULL, NULL, 0, 0, 0);
}

static void *getproc(const char *name) {
    return (void *)osmesa.GetProcAddress(name);
}

const struct platform osmesa_platform = {list, create, destroy, bind, unbind, getproc};
