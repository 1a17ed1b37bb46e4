/* A context that the caller made for the library: its objects go with the device, the caller's own
 * context shows its pictures, and they are those of a context of the library's own. */
#define _XOPEN_SOURCE 700
#include "library_support.h"

#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/glcorearb.h>

#include <dlfcn.h>

#define BOX "scenes/cornell-box.glb"

/* --- contexts of the test's own ----------------------------------------------------------------
 */

static struct {
    PFNEGLGETPROCADDRESSPROC get;
    PFNEGLMAKECURRENTPROC make_current;
    PFNEGLDESTROYCONTEXTPROC destroy;
    EGLDisplay display;
    EGLContext drawing, context; /* the caller's, and the library's, which share objects */
    int made, released;
} host;

static void *get_proc(void *user, const char *name) {
    (void)user;
    return (void *)host.get(name);
}

static int make_current(void *user) {
    (void)user;
    host.made++;
    return !host.make_current(host.display, EGL_NO_SURFACE, EGL_NO_SURFACE, host.context);
}

static void release_current(void *user) {
    (void)user;
    host.released++;
    host.make_current(host.display, EGL_NO_SURFACE, EGL_NO_SURFACE, host.drawing);
}

static const struct manylight_host kept_current = {.size = sizeof kept_current,
                                                   .get_proc = get_proc};
static const struct manylight_host bound_by_calls = {.size = sizeof bound_by_calls,
                                                     .get_proc = get_proc,
                                                     .make_current = make_current,
                                                     .release_current = release_current};

static int open_host(void **state) {
    (void)state;
    static const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                        4,
                                        EGL_CONTEXT_MINOR_VERSION,
                                        5,
                                        EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                        EGL_NONE};
    void *library = dlopen("libEGL.so.1", RTLD_NOW);
    if (!library)
        return 0;
    *(void **)&host.get = dlsym(library, "eglGetProcAddress");
    PFNEGLGETPLATFORMDISPLAYEXTPROC get_display =
        (PFNEGLGETPLATFORMDISPLAYEXTPROC)host.get("eglGetPlatformDisplayEXT");
    host.make_current = (PFNEGLMAKECURRENTPROC)host.get("eglMakeCurrent");
    host.destroy = (PFNEGLDESTROYCONTEXTPROC)host.get("eglDestroyContext");
    host.display = get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
    PFNEGLCREATECONTEXTPROC create = (PFNEGLCREATECONTEXTPROC)host.get("eglCreateContext");
    if (((PFNEGLINITIALIZEPROC)host.get("eglInitialize"))(host.display, NULL, NULL) &&
        ((PFNEGLBINDAPIPROC)host.get("eglBindAPI"))(EGL_OPENGL_API)) {
        host.drawing = create(host.display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
        host.context = create(host.display, EGL_NO_CONFIG_KHR, host.drawing, attributes);
    }
    return 0;
}

static int close_host(void **state) {
    (void)state;
    if (host.context) {
        host.make_current(host.display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        host.destroy(host.display, host.context);
        host.destroy(host.display, host.drawing);
    }
    return 0;
}

static void need_host(void) {
    if (host.context)
        return;
    printf("    skipped: EGL has no surfaceless context\n");
    skip();
}

static struct manylight_device *adopt(const struct manylight_host *by) {
    struct manylight_device *device;
    const struct manylight_device_desc desc = {.size = sizeof desc, .host = by};
    check_call("adopt", manylight_device_create(&desc, &device));
    return device;
}

/* --- pictures --------------------------------------------------------------------------------- */

TEST(adopted_and_own) {
    need_host();
    struct manylight_device *own = open_device(), *adopted = adopt(&bound_by_calls);
    struct manylight_scene *scene = open_scene(BOX);
    struct manylight_image *a = draw_once(own, scene, NULL, NULL),
                           *b = draw_once(adopted, scene, NULL, NULL),
                           *c = draw_once(own, scene, NULL, NULL);
    assert_true(same_images(a, b));
    assert_true(same_images(a, c));
    manylight_image_free(a);
    manylight_image_free(b);
    manylight_image_free(c);
    manylight_scene_free(scene);
    manylight_device_free(own);
    manylight_device_free(adopted);
    printf("    bound %d times, released %d times\n", host.made, host.released);
    assert_true(host.made > 4);
    assert_int_equal(host.made, host.released);
}

static int refuse_current(void *user) {
    (void)user;
    return 1;
}

static void *no_functions(void *user, const char *name) {
    (void)user, (void)name;
    return NULL;
}

TEST(refusals) {
    struct manylight_device *device;
    struct manylight_host broken = {
        .size = sizeof broken, .get_proc = no_functions, .make_current = refuse_current};
    const struct manylight_device_desc desc = {.size = sizeof desc, .host = &broken};
    check_failed(manylight_device_create(&desc, &device), MANYLIGHT_NO_DEVICE,
                 "make_current failed");
    broken.make_current = NULL;
    check_failed(manylight_device_create(&desc, &device), MANYLIGHT_NO_DEVICE, "no function gl");
    assert_null(device);
}

/* The caller's context reads the picture from the texture of the library's. */
TEST(texture_is_shared) {
    need_host();
    enum { WIDTH = 48, HEIGHT = 40, ROW = 4 * WIDTH };
    static uint8_t texels[HEIGHT][ROW], picture[HEIGHT][ROW];
    struct manylight_device *device = adopt(&bound_by_calls);
    struct manylight_scene *scene = open_scene(BOX);
    const struct manylight_renderer_desc desc = {.width = WIDTH, .height = HEIGHT};
    struct manylight_renderer *renderer = open_drawing(device, scene, &desc);
    uint32_t texture;
    int width, height;
    check_call("render", manylight_render(renderer, NULL));
    check_call("read", manylight_read_display(renderer, NULL, *picture, sizeof picture));
    check_call("texture", manylight_display_texture(renderer, NULL, &texture, &width, &height));
    assert_true(width == WIDTH && height == HEIGHT);
    PFNGLGETTEXTUREIMAGEPROC read = (PFNGLGETTEXTUREIMAGEPROC)host.get("glGetTextureImage");
    read(texture, 0, GL_RGBA, GL_UNSIGNED_BYTE, sizeof texels, texels);
    for (int y = 0; y < HEIGHT; y++)
        assert_memory_equal(texels[HEIGHT - 1 - y], picture[y], ROW);
    manylight_renderer_free(renderer);
    manylight_scene_free(scene);
    manylight_device_free(device);
}

/* --- objects ---------------------------------------------------------------------------------- */

/* Objects of the context, of names up to a bound. Drivers give new names to what is made anew. */
static int count_objects(void) {
    static const char *const kinds[] = {"glIsTexture",     "glIsBuffer",      "glIsProgram",
                                        "glIsFramebuffer", "glIsVertexArray", "glIsQuery"};
    int count = 0;
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        PFNGLISTEXTUREPROC is_object = (PFNGLISTEXTUREPROC)host.get(kinds[i]);
        for (GLuint name = 1; name < (is_long_run() ? 100000 : 3000); name++)
            count += is_object(name);
    }
    return count;
}

TEST(objects_go) {
    need_host();
    assert_int_equal(make_current(NULL), 0);
    struct manylight_scene *scene = open_scene(BOX);
    int objects_before = count_objects(), during = 0;
    for (int i = 0; i < (is_long_run() ? 100 : 5); i++) {
        const struct manylight_renderer_desc desc = {.width = 16, .height = 16};
        struct manylight_device *device = adopt(&kept_current);
        struct manylight_renderer *renderer = open_drawing(device, scene, &desc);
        check_call("render", manylight_render(renderer, NULL));
        if (i == 0)
            during = count_objects();
        manylight_device_free(device);
        manylight_renderer_free(renderer);
    }
    printf("    %d objects, %d while it renders, %d after\n", objects_before, during,
           count_objects());
    assert_true(during > objects_before + 20);
    assert_int_equal(count_objects(), objects_before);
    manylight_scene_free(scene);
    release_current(NULL);
}

RUN_TESTS(open_host, close_host)
