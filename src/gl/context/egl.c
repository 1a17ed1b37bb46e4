/* EGL without a window: on a device (EGL_EXT_platform_device) or surfaceless (Mesa's platform). */
#include "gl/context/platform.h"

#include "base/error.h"

#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define EGL_FUNCTIONS(X)                                                                           \
    X(PFNEGLGETERRORPROC, GetError)                                                                \
    X(PFNEGLQUERYSTRINGPROC, QueryString)                                                          \
    X(PFNEGLINITIALIZEPROC, Initialize)                                                            \
    X(PFNEGLBINDAPIPROC, BindAPI)                                                                  \
    X(PFNEGLCREATECONTEXTPROC, CreateContext)                                                      \
    X(PFNEGLDESTROYCONTEXTPROC, DestroyContext)                                                    \
    X(PFNEGLMAKECURRENTPROC, MakeCurrent)

/* Opened once and never closed: drivers keep per-thread state. */
static struct {
    void *library;
    PFNEGLGETPROCADDRESSPROC GetProcAddress;
#define EGL_MEMBER(type, name) type name;
    EGL_FUNCTIONS(EGL_MEMBER)
#undef EGL_MEMBER
    PFNEGLGETPLATFORMDISPLAYEXTPROC GetPlatformDisplay;
} egl;

/* Whether a word is in a list of words. */
static bool has(const char *extensions, const char *name) {
    size_t length = strlen(name);
    for (const char *at = extensions; at && (at = strstr(at, name)); at += length)
        if ((at == extensions || at[-1] == ' ') && (at[length] == ' ' || at[length] == '\0'))
            return true;
    return false;
}

static const char *error_name(EGLint error) {
    static const char *const names[] = {
        "EGL_SUCCESS",       "EGL_NOT_INITIALIZED",     "EGL_BAD_ACCESS",
        "EGL_BAD_ALLOC",     "EGL_BAD_ATTRIBUTE",       "EGL_BAD_CONFIG",
        "EGL_BAD_CONTEXT",   "EGL_BAD_CURRENT_SURFACE", "EGL_BAD_DISPLAY",
        "EGL_BAD_MATCH",     "EGL_BAD_NATIVE_PIXMAP",   "EGL_BAD_NATIVE_WINDOW",
        "EGL_BAD_PARAMETER", "EGL_BAD_SURFACE",         "EGL_CONTEXT_LOST",
    };
    unsigned index = (unsigned)error - EGL_SUCCESS;
    return index < sizeof names / sizeof *names ? names[index] : "unknown error";
}

static bool refuse(const char *call) {
    return error_set("%s: %s", call, error_name(egl.GetError()));
}

static bool find(const char *name, void *function) {
    void *found = (void *)egl.GetProcAddress(name);
    memcpy(function, &found, sizeof found);
    return found || error_set("libEGL has no %s", name);
}

static bool open_library(void) {
    if (egl.library)
        return true;
    void *library = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
    if (!library)
        return error_set("cannot open libEGL.so.1");
    void *found = dlsym(library, "eglGetProcAddress");
    if (!found)
        return error_set("libEGL has no eglGetProcAddress");
    memcpy(&egl.GetProcAddress, &found, sizeof found);
#define EGL_FIND(type, name)                                                                       \
    if (!find("egl" #name, &egl.name))                                                             \
        return false;
    EGL_FUNCTIONS(EGL_FIND)
#undef EGL_FIND
    if (!find("eglGetPlatformDisplayEXT", &egl.GetPlatformDisplay))
        return false;
    egl.library = library;
    return true;
}

/* EGL and CUDA count devices in orders of their own. */
static int cuda_number(EGLDeviceEXT device, const char *extensions) {
    PFNEGLQUERYDEVICEATTRIBEXTPROC query_attribute;
    EGLAttrib number = -1;
    if (!has(extensions, "EGL_NV_device_cuda") ||
        !find("eglQueryDeviceAttribEXT", &query_attribute) ||
        !query_attribute(device, EGL_CUDA_DEVICE_NV, &number))
        return -1;
    return (int)number;
}

/* "EGL device 0 (/dev/dri/card0, cuda:1)", "EGL device 1 (software)". */
static void name_device(struct candidate *candidate, PFNEGLQUERYDEVICESTRINGEXTPROC query) {
    const char *extensions = query(candidate->device, EGL_EXTENSIONS);
    const char *file = NULL;
    char cuda[24] = "", about[80];
    if (has(extensions, "EGL_EXT_device_drm"))
        file = query(candidate->device, EGL_DRM_DEVICE_FILE_EXT);
    candidate->software = has(extensions, "EGL_MESA_device_software");
    candidate->cuda = cuda_number(candidate->device, extensions);
    if (candidate->cuda >= 0)
        snprintf(cuda, sizeof cuda, "cuda:%d", candidate->cuda);
    snprintf(about, sizeof about, "%s%s%s",
             candidate->software ? "software"
             : file              ? file
                                 : "",
             file && *cuda ? ", " : "", cuda);
    snprintf(candidate->name, sizeof candidate->name, "EGL device %d%s%s%s", candidate->number,
             *about ? " (" : "", about, *about ? ")" : "");
}

/* The devices in EGL's own order. Without the extensions there are none, which is no error. */
static int query_devices(struct candidate *candidates, int max) {
    PFNEGLQUERYDEVICESEXTPROC query_devices;
    PFNEGLQUERYDEVICESTRINGEXTPROC query_string;
    EGLDeviceEXT devices[CANDIDATES_MAX];
    EGLint count = 0;
    if (!find("eglQueryDevicesEXT", &query_devices) ||
        !find("eglQueryDeviceStringEXT", &query_string) || !query_devices(max, devices, &count))
        return 0;
    for (int i = 0; i < count; i++) {
        candidates[i] = (struct candidate){&egl_platform, devices[i], i, -1, false, ""};
        name_device(&candidates[i], query_string);
    }
    return count;
}

static void append(struct candidate_list *list, const struct candidate *candidate) {
    if (list->count < CANDIDATES_MAX)
        list->items[list->count++] = *candidate;
}

/* Hardware devices, then surfaceless (which may find hardware that is listed as no device), then
 * software devices. */
static bool list(struct candidate_list *list) {
    if (!open_library())
        return error_prefix("EGL");
    struct candidate devices[CANDIDATES_MAX];
    const struct candidate surfaceless = {&egl_platform, NULL, -1, -1, false, "EGL surfaceless"};
    int before = list->count, count = query_devices(devices, CANDIDATES_MAX);
    for (int i = 0; i < count; i++)
        if (!devices[i].software)
            append(list, &devices[i]);
    if (has(egl.QueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS), "EGL_MESA_platform_surfaceless"))
        append(list, &surfaceless);
    for (int i = 0; i < count; i++)
        if (devices[i].software)
            append(list, &devices[i]);
    return list->count > before || error_set("EGL: no driver has devices or is surfaceless");
}

/* EGL gives the same display to all contexts of a device, so no context may terminate it. */
static bool open_display(EGLDisplay *display, EGLDeviceEXT device) {
    EGLenum platform = device ? EGL_PLATFORM_DEVICE_EXT : EGL_PLATFORM_SURFACELESS_MESA;
    *display =
        egl.GetPlatformDisplay(platform, device ? device : (void *)EGL_DEFAULT_DISPLAY, NULL);
    if (*display == EGL_NO_DISPLAY)
        return refuse("eglGetPlatformDisplay");
    if (!egl.Initialize(*display, NULL, NULL))
        return refuse("eglInitialize");
    const char *extensions = egl.QueryString(*display, EGL_EXTENSIONS);
    static const char *const needed[] = {"EGL_KHR_create_context", "EGL_KHR_no_config_context",
                                         "EGL_KHR_surfaceless_context"};
    for (size_t i = 0; i < sizeof needed / sizeof *needed; i++)
        if (!has(extensions, needed[i]))
            return error_set("lacks %s", needed[i]);
    return true;
}

/* Not every driver tells of resets (context_check). */
static EGLContext create_context(EGLDisplay display, bool debug, bool tells_resets) {
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                 4,
                                 EGL_CONTEXT_MINOR_VERSION,
                                 5,
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                 EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                 EGL_CONTEXT_OPENGL_DEBUG,
                                 debug,
                                 tells_resets ? EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY
                                              : EGL_NONE,
                                 EGL_LOSE_CONTEXT_ON_RESET,
                                 EGL_NONE};
    return egl.CreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
}

static bool create(struct native_context *native, const struct candidate *candidate, bool debug) {
    EGLDisplay display;
    if (!open_display(&display, candidate->device))
        return false;
    if (!egl.BindAPI(EGL_OPENGL_API))
        return refuse("eglBindAPI(EGL_OPENGL_API)");
    EGLContext handle = create_context(display, debug, true);
    if (handle == EGL_NO_CONTEXT)
        handle = create_context(display, debug, false);
    if (handle == EGL_NO_CONTEXT)
        return refuse("no OpenGL 4.5 core context: eglCreateContext");
    *native = (struct native_context){&egl_platform, handle, display};
    return true;
}

static void destroy(struct native_context *native) {
    egl.DestroyContext(native->surface, native->handle);
}

static bool bind(const struct native_context *native) {
    return egl.MakeCurrent(native->surface, EGL_NO_SURFACE, EGL_NO_SURFACE, native->handle) ||
           refuse("eglMakeCurrent");
}

static void unbind(const struct native_context *native) {
    egl.MakeCurrent(native->surface, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

static void *getproc(const char *name) {
    return (void *)egl.GetProcAddress(name);
}

const struct platform egl_platform = {list, create, destroy, bind, unbind, getproc};
