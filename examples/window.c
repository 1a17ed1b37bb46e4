/* A window of the program's own that shows pictures of libmanylight. The camera moves to and fro.
 *
 *     cc window.c -o window $(pkg-config --cflags --libs manylight glfw3 gl) -lm
 *     ./window scene.glb [FRAMES]
 *
 * The library has a context of its own, that of a hidden window which shares textures with the
 * shown one. So the state of the program's context stays. */
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <manylight.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { WIDTH = 400, HEIGHT = 300 };

static void *get_proc(void *user, const char *name) {
    (void)user;
    return (void *)glfwGetProcAddress(name);
}

struct parts {
    GLFWwindow *window, *library; /* shown; hidden, with the library's context */
    struct manylight_device *device;
    struct manylight_scene *scene;
    struct manylight_renderer *renderer;
    struct manylight_scene_info info;
    GLuint framebuffer; /* to copy the library's texture from */
};

static int make_current(void *user) {
    glfwMakeContextCurrent(((struct parts *)user)->library);
    return 0;
}

static void release_current(void *user) {
    glfwMakeContextCurrent(((struct parts *)user)->window);
}

static int open_window(struct parts *parts) {
    if (!glfwInit())
        return 0;
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    parts->window = glfwCreateWindow(WIDTH, HEIGHT, "manylight in a window", NULL, NULL);
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    parts->library = glfwCreateWindow(1, 1, "", NULL, parts->window);
    if (!parts->window || !parts->library)
        return 0;
    glfwMakeContextCurrent(parts->window);
    glCreateFramebuffers(1, &parts->framebuffer);
    return 1;
}

static int open_library(struct parts *parts, const char *path) {
    struct manylight_host host = {.size = sizeof host,
                                  .get_proc = get_proc,
                                  .make_current = make_current,
                                  .release_current = release_current,
                                  .user = parts};
    struct manylight_device_desc device = {.size = sizeof device, .host = &host};
    struct manylight_scene_desc scene = {.size = sizeof scene, .path = path};
    struct manylight_renderer_desc renderer = {
        .size = sizeof renderer, .width = WIDTH, .height = HEIGHT, .keep_lights = 1};
    parts->info.size = sizeof parts->info;
    return !manylight_device_create(&device, &parts->device) &&
           !manylight_scene_open(&scene, &parts->scene) &&
           !manylight_scene_info(parts->scene, &parts->info) &&
           !manylight_renderer_create(parts->device, parts->scene, &renderer, &parts->renderer);
}

/* The scene's camera, to and fro by a tenth of the scene's radius. */
static int draw(const struct parts *parts, int frame) {
    struct manylight_camera camera = {.size = sizeof camera};
    struct manylight_view view = {.size = sizeof view, .placed = &camera};
    uint32_t texture;
    int width, height;
    if (manylight_scene_camera(parts->scene, NULL, 0, &camera))
        return 0;
    float step = .1F * parts->info.radius * sinf((float)frame * .1F);
    for (int c = 0; c < 3; c++)
        camera.eye[c] += step * camera.right[c];
    if (manylight_render(parts->renderer, &view) ||
        manylight_display_texture(parts->renderer, NULL, &texture, &width, &height))
        return 0;
    glNamedFramebufferTexture(parts->framebuffer, GL_COLOR_ATTACHMENT0, texture, 0);
    glBlitNamedFramebuffer(parts->framebuffer, 0, 0, 0, width, height, 0, 0, WIDTH, HEIGHT,
                           GL_COLOR_BUFFER_BIT, GL_LINEAR);
    glfwSwapBuffers(parts->window);
    return 1;
}

int main(int argc, char **argv) {
    struct parts parts = {0};
    if (argc < 2) {
        fprintf(stderr, "usage: window SCENE.glb [FRAMES]\n");
        return 2;
    }
    int frames = argc > 2 ? atoi(argv[2]) : 1 << 30, ok = 0;
    if (!open_window(&parts)) {
        fprintf(stderr, "window: no window with OpenGL 4.5\n");
    } else {
        ok = open_library(&parts, argv[1]);
        for (int i = 0; ok && i < frames && !glfwWindowShouldClose(parts.window); i++) {
            ok = draw(&parts, i);
            glfwPollEvents();
        }
        if (!ok)
            fprintf(stderr, "window: %s\n", manylight_error());
    }
    /* The library's objects end while the context is there. */
    manylight_renderer_free(parts.renderer);
    manylight_scene_free(parts.scene);
    manylight_device_free(parts.device);
    glfwTerminate();
    return ok ? 0 : 1;
}
