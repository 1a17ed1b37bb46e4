/* A context that is the caller's: its state stays, its objects go with the device, and its pictures
 * are those of a context of the library's own in the same process. */
#define _XOPEN_SOURCE 700
#include "library_support.h"

#include "gl/screen.h"

#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/glcorearb.h>

#include <dlfcn.h>

#define BOX "scenes/cornell-box.glb"

/* --- a context of the test's own -------------------------------------------------------------- */

static struct {
    PFNEGLGETPROCADDRESSPROC get;
    PFNEGLMAKECURRENTPROC make_current;
    PFNEGLDESTROYCONTEXTPROC destroy;
    EGLDisplay display;
    EGLContext context;
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
    host.make_current(host.display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
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
    if (((PFNEGLINITIALIZEPROC)host.get("eglInitialize"))(host.display, NULL, NULL) &&
        ((PFNEGLBINDAPIPROC)host.get("eglBindAPI"))(EGL_OPENGL_API))
        host.context = ((PFNEGLCREATECONTEXTPROC)host.get("eglCreateContext"))(
            host.display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
    return 0;
}

static int close_host(void **state) {
    (void)state;
    if (host.context)
        host.destroy(host.display, host.context);
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

/* --- state ------------------------------------------------------------------------------------ */

#define FUNCTIONS(X)                                                                               \
    X(PFNGLENABLEIPROC, Enablei)                                                                   \
    X(PFNGLDISABLEIPROC, Disablei)                                                                 \
    X(PFNGLENABLEPROC, Enable)                                                                     \
    X(PFNGLDISABLEPROC, Disable)                                                                   \
    X(PFNGLISENABLEDPROC, IsEnabled)                                                               \
    X(PFNGLISENABLEDIPROC, IsEnabledi)                                                             \
    X(PFNGLGETINTEGERVPROC, GetIntegerv)                                                           \
    X(PFNGLGETINTEGERI_VPROC, GetIntegeri_v)                                                       \
    X(PFNGLGETINTEGER64I_VPROC, GetInteger64i_v)                                                   \
    X(PFNGLGETFLOATI_VPROC, GetFloati_v)                                                           \
    X(PFNGLGETDOUBLEI_VPROC, GetDoublei_v)                                                         \
    X(PFNGLGETERRORPROC, GetError)                                                                 \
    X(PFNGLCREATETEXTURESPROC, CreateTextures)                                                     \
    X(PFNGLTEXTURESTORAGE2DPROC, TextureStorage2D)                                                 \
    X(PFNGLTEXTURESTORAGE3DPROC, TextureStorage3D)                                                 \
    X(PFNGLCREATEBUFFERSPROC, CreateBuffers)                                                       \
    X(PFNGLNAMEDBUFFERSTORAGEPROC, NamedBufferStorage)                                             \
    X(PFNGLCREATESAMPLERSPROC, CreateSamplers)                                                     \
    X(PFNGLCREATEFRAMEBUFFERSPROC, CreateFramebuffers)                                             \
    X(PFNGLCREATEVERTEXARRAYSPROC, CreateVertexArrays)                                             \
    X(PFNGLCREATETRANSFORMFEEDBACKSPROC, CreateTransformFeedbacks)                                 \
    X(PFNGLACTIVETEXTUREPROC, ActiveTexture)                                                       \
    X(PFNGLBINDTEXTUREUNITPROC, BindTextureUnit)                                                   \
    X(PFNGLBINDSAMPLERPROC, BindSampler)                                                           \
    X(PFNGLBINDIMAGETEXTUREPROC, BindImageTexture)                                                 \
    X(PFNGLBINDBUFFERPROC, BindBuffer)                                                             \
    X(PFNGLBINDBUFFERRANGEPROC, BindBufferRange)                                                   \
    X(PFNGLBINDTRANSFORMFEEDBACKPROC, BindTransformFeedback)                                       \
    X(PFNGLBINDFRAMEBUFFERPROC, BindFramebuffer)                                                   \
    X(PFNGLBINDVERTEXARRAYPROC, BindVertexArray)                                                   \
    X(PFNGLCREATESHADERPROGRAMVPROC, CreateShaderProgramv)                                         \
    X(PFNGLUSEPROGRAMPROC, UseProgram)                                                             \
    X(PFNGLVIEWPORTINDEXEDFPROC, ViewportIndexedf)                                                 \
    X(PFNGLDEPTHRANGEINDEXEDPROC, DepthRangeIndexed)                                               \
    X(PFNGLSCISSORPROC, Scissor)                                                                   \
    X(PFNGLBLENDFUNCSEPARATEIPROC, BlendFuncSeparatei)                                             \
    X(PFNGLBLENDEQUATIONSEPARATEIPROC, BlendEquationSeparatei)                                     \
    X(PFNGLCOLORMASKIPROC, ColorMaski)                                                             \
    X(PFNGLDEPTHFUNCPROC, DepthFunc)                                                               \
    X(PFNGLDEPTHMASKPROC, DepthMask)                                                               \
    X(PFNGLCULLFACEPROC, CullFace)                                                                 \
    X(PFNGLFRONTFACEPROC, FrontFace)                                                               \
    X(PFNGLPOLYGONMODEPROC, PolygonMode)                                                           \
    X(PFNGLCLIPCONTROLPROC, ClipControl)                                                           \
    X(PFNGLPROVOKINGVERTEXPROC, ProvokingVertex)                                                   \
    X(PFNGLPOINTSIZEPROC, PointSize)                                                               \
    X(PFNGLPIXELSTOREIPROC, PixelStorei)                                                           \
    X(PFNGLSTENCILFUNCPROC, StencilFunc)                                                           \
    X(PFNGLISTEXTUREPROC, IsTexture)                                                               \
    X(PFNGLISBUFFERPROC, IsBuffer)                                                                 \
    X(PFNGLISPROGRAMPROC, IsProgram)                                                               \
    X(PFNGLISFRAMEBUFFERPROC, IsFramebuffer)                                                       \
    X(PFNGLISVERTEXARRAYPROC, IsVertexArray)                                                       \
    X(PFNGLISQUERYPROC, IsQuery)

static struct {
#define MEMBER(type, name) type name;
    FUNCTIONS(MEMBER)
#undef MEMBER
} gl_;

static void load_functions(void) {
#define FIND(type, name) gl_.name = (type)host.get("gl" #name);
    FUNCTIONS(FIND)
#undef FIND
}

static unsigned seed;

static unsigned pick(unsigned count) {
    seed = seed * 1664525u + 1013904223u;
    return (seed >> 8) % count;
}

enum { UNITS = 96, OBJECTS = 4 };

static struct {
    GLuint textures[OBJECTS], arrays[OBJECTS], buffers[OBJECTS], samplers[OBJECTS],
        framebuffers[OBJECTS], vertex_arrays[OBJECTS], feedbacks[OBJECTS], programs[OBJECTS];
} objects;

static void make_objects(void) {
    const char *source = "#version 450\nout vec4 c; void main() { c = vec4(1); }";
    gl_.CreateTextures(GL_TEXTURE_2D, OBJECTS, objects.textures);
    gl_.CreateTextures(GL_TEXTURE_2D_ARRAY, OBJECTS, objects.arrays);
    gl_.CreateBuffers(OBJECTS, objects.buffers);
    gl_.CreateSamplers(OBJECTS, objects.samplers);
    gl_.CreateFramebuffers(OBJECTS, objects.framebuffers);
    gl_.CreateVertexArrays(OBJECTS, objects.vertex_arrays);
    gl_.CreateTransformFeedbacks(OBJECTS, objects.feedbacks);
    for (int i = 0; i < OBJECTS; i++) {
        gl_.TextureStorage2D(objects.textures[i], 1, GL_RGBA8, 4, 4);
        gl_.TextureStorage3D(objects.arrays[i], 1, GL_RGBA8, 4, 4, 2);
        gl_.NamedBufferStorage(objects.buffers[i], 4096, NULL, 0);
        objects.programs[i] = gl_.CreateShaderProgramv(GL_FRAGMENT_SHADER, 1, &source);
    }
}

static GLuint some(const GLuint names[OBJECTS]) {
    return pick(3) ? names[pick(OBJECTS)] : 0;
}

static const GLenum capabilities[] = {
    GL_DEPTH_TEST,
    GL_STENCIL_TEST,
    GL_CULL_FACE,
    GL_DITHER,
    GL_MULTISAMPLE,
    GL_POLYGON_OFFSET_FILL,
    GL_POLYGON_OFFSET_LINE,
    GL_COLOR_LOGIC_OP,
    GL_SAMPLE_ALPHA_TO_COVERAGE,
    GL_SAMPLE_ALPHA_TO_ONE,
    GL_SAMPLE_COVERAGE,
    GL_SAMPLE_MASK,
    GL_SAMPLE_SHADING,
    GL_PRIMITIVE_RESTART,
    GL_PRIMITIVE_RESTART_FIXED_INDEX,
    GL_DEPTH_CLAMP,
    GL_FRAMEBUFFER_SRGB,
    GL_RASTERIZER_DISCARD,
    GL_LINE_SMOOTH,
    GL_POLYGON_SMOOTH,
    GL_PROGRAM_POINT_SIZE,
    GL_TEXTURE_CUBE_MAP_SEAMLESS,
    GL_CLIP_DISTANCE0,
    GL_CLIP_DISTANCE3,
    GL_CLIP_DISTANCE6,
};

#define COUNT(array) (sizeof(array) / sizeof *(array))

static void shuffle_bindings(void) {
    for (GLuint unit = 0; unit < UNITS; unit++) {
        gl_.BindTextureUnit(unit, 0);
        gl_.BindTextureUnit(unit, some(objects.textures));
        if (pick(2))
            gl_.BindTextureUnit(unit, objects.arrays[pick(OBJECTS)]);
        gl_.BindSampler(unit, some(objects.samplers));
    }
    gl_.ActiveTexture(GL_TEXTURE0 + pick(UNITS));
    for (GLuint i = 0; i < 8; i++)
        gl_.BindImageTexture(i, some(objects.textures), 0, GL_FALSE, 0, GL_READ_ONLY, GL_RGBA8);
    for (GLuint i = 0; i < 14; i++)
        gl_.BindBufferRange(GL_UNIFORM_BUFFER, i, objects.buffers[pick(OBJECTS)], 256 * pick(4),
                            64 + 16 * pick(4));
    for (GLuint i = 0; i < 8; i++)
        gl_.BindBufferRange(GL_SHADER_STORAGE_BUFFER, i, objects.buffers[pick(OBJECTS)],
                            256 * pick(4), 64);
    gl_.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, 0);
    gl_.BindBufferRange(GL_TRANSFORM_FEEDBACK_BUFFER, 0, objects.buffers[pick(OBJECTS)], 64, 128);
    gl_.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, some(objects.feedbacks));
    gl_.BindBuffer(GL_UNIFORM_BUFFER, some(objects.buffers));
    gl_.BindBuffer(GL_SHADER_STORAGE_BUFFER, some(objects.buffers));
    gl_.BindBuffer(GL_DISPATCH_INDIRECT_BUFFER, some(objects.buffers));
    gl_.BindBuffer(GL_PIXEL_PACK_BUFFER, some(objects.buffers));
    gl_.BindBuffer(GL_PIXEL_UNPACK_BUFFER, some(objects.buffers));
    gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, some(objects.framebuffers));
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, some(objects.framebuffers));
    gl_.BindVertexArray(some(objects.vertex_arrays));
    gl_.UseProgram(pick(2) ? objects.programs[pick(OBJECTS)] : 0);
}

static void shuffle_modes(void) {
    static const GLenum factors[] = {GL_ZERO, GL_ONE, GL_SRC_ALPHA, GL_DST_COLOR};
    static const GLenum equations[] = {GL_FUNC_ADD, GL_MIN, GL_MAX, GL_FUNC_SUBTRACT};
    for (size_t i = 0; i < COUNT(capabilities); i++)
        (pick(2) ? gl_.Enable : gl_.Disable)(capabilities[i]);
    for (GLuint i = 0; i < 8; i++) {
        (pick(2) ? gl_.Enablei : gl_.Disablei)(GL_BLEND, i);
        gl_.BlendFuncSeparatei(i, factors[pick(4)], factors[pick(4)], factors[pick(4)],
                               factors[pick(4)]);
        gl_.BlendEquationSeparatei(i, equations[pick(4)], equations[pick(4)]);
        gl_.ColorMaski(i, pick(2), pick(2), pick(2), pick(2));
    }
    for (GLuint i = 0; i < 16; i++) {
        (pick(2) ? gl_.Enablei : gl_.Disablei)(GL_SCISSOR_TEST, i);
        gl_.ViewportIndexedf(i, (float)pick(9), (float)pick(9), (float)(1 + pick(99)),
                             (float)(1 + pick(99)));
        gl_.DepthRangeIndexed(i, pick(5) / 10., pick(10) / 10.);
    }
    gl_.Scissor(0, 0, 1, 1);
    gl_.DepthFunc(GL_NEVER + pick(8));
    gl_.DepthMask(pick(2));
    gl_.StencilFunc(GL_NEVER, 1, 1);
    gl_.CullFace(pick(2) ? GL_FRONT : GL_FRONT_AND_BACK);
    gl_.FrontFace(pick(2) ? GL_CW : GL_CCW);
    gl_.PolygonMode(GL_FRONT_AND_BACK, pick(2) ? GL_LINE : GL_POINT);
    gl_.ClipControl(pick(2) ? GL_UPPER_LEFT : GL_LOWER_LEFT,
                    pick(2) ? GL_ZERO_TO_ONE : GL_NEGATIVE_ONE_TO_ONE);
    gl_.ProvokingVertex(pick(2) ? GL_FIRST_VERTEX_CONVENTION : GL_LAST_VERTEX_CONVENTION);
    gl_.PointSize(1 + (float)pick(5));
    gl_.PixelStorei(GL_PACK_ALIGNMENT, pick(2) ? 1 : 8);
    gl_.PixelStorei(GL_PACK_ROW_LENGTH, (GLint)pick(99));
    gl_.PixelStorei(GL_UNPACK_ALIGNMENT, pick(2) ? 1 : 8);
    gl_.PixelStorei(GL_UNPACK_SKIP_ROWS, (GLint)pick(9));
    gl_.PixelStorei(GL_UNPACK_SWAP_BYTES, (GLint)pick(2));
}

/* All state that OpenGL tells, as numbers; written without a look at how the library saves it. */
enum { NUMBERS_MAX = 4096 };

struct numbers {
    double values[NUMBERS_MAX];
    size_t count;
};

static void add(struct numbers *numbers, double value) {
    assert_true(numbers->count < NUMBERS_MAX);
    numbers->values[numbers->count++] = value;
}

static void add_integer(struct numbers *numbers, GLenum name) {
    GLint values[8] = {0};
    gl_.GetIntegerv(name, values);
    for (int i = 0; i < 4; i++)
        add(numbers, values[i]);
}

static void add_indexed(struct numbers *numbers, GLenum name, GLuint count) {
    for (GLuint i = 0; i < count; i++) {
        GLint64 values[8] = {0};
        gl_.GetInteger64i_v(name, i, values);
        add(numbers, (double)values[0]);
    }
}

static void read_state(struct numbers *numbers) {
    static const GLenum plain[] = {GL_UNIFORM_BUFFER_BINDING,
                                   GL_SHADER_STORAGE_BUFFER_BINDING,
                                   GL_TRANSFORM_FEEDBACK_BUFFER_BINDING,
                                   GL_TRANSFORM_FEEDBACK_BINDING,
                                   GL_PIXEL_PACK_BUFFER_BINDING,
                                   GL_PIXEL_UNPACK_BUFFER_BINDING,
                                   GL_ARRAY_BUFFER_BINDING,
                                   GL_DRAW_INDIRECT_BUFFER_BINDING,
                                   GL_DISPATCH_INDIRECT_BUFFER_BINDING,
                                   GL_COPY_READ_BUFFER_BINDING,
                                   GL_DRAW_FRAMEBUFFER_BINDING,
                                   GL_READ_FRAMEBUFFER_BINDING,
                                   GL_RENDERBUFFER_BINDING,
                                   GL_VERTEX_ARRAY_BINDING,
                                   GL_CURRENT_PROGRAM,
                                   GL_PROGRAM_PIPELINE_BINDING,
                                   GL_ACTIVE_TEXTURE,
                                   GL_DEPTH_FUNC,
                                   GL_DEPTH_WRITEMASK,
                                   GL_STENCIL_FUNC,
                                   GL_STENCIL_WRITEMASK,
                                   GL_CULL_FACE_MODE,
                                   GL_FRONT_FACE,
                                   GL_POLYGON_MODE,
                                   GL_CLIP_ORIGIN,
                                   GL_CLIP_DEPTH_MODE,
                                   GL_PROVOKING_VERTEX,
                                   GL_POINT_SIZE,
                                   GL_LINE_WIDTH,
                                   GL_LOGIC_OP_MODE,
                                   GL_SCISSOR_BOX,
                                   GL_BLEND_COLOR,
                                   GL_COLOR_CLEAR_VALUE,
                                   GL_PATCH_VERTICES,
                                   GL_PRIMITIVE_RESTART_INDEX,
                                   GL_PACK_ALIGNMENT,
                                   GL_PACK_ROW_LENGTH,
                                   GL_PACK_SKIP_PIXELS,
                                   GL_UNPACK_ALIGNMENT,
                                   GL_UNPACK_SKIP_ROWS,
                                   GL_UNPACK_SWAP_BYTES,
                                   GL_UNPACK_IMAGE_HEIGHT,
                                   GL_DEBUG_GROUP_STACK_DEPTH};
    static const struct {
        GLenum name;
        GLuint count;
    } indexed[] = {{GL_UNIFORM_BUFFER_BINDING, 14},
                   {GL_UNIFORM_BUFFER_START, 14},
                   {GL_UNIFORM_BUFFER_SIZE, 14},
                   {GL_SHADER_STORAGE_BUFFER_BINDING, 8},
                   {GL_SHADER_STORAGE_BUFFER_START, 8},
                   {GL_SHADER_STORAGE_BUFFER_SIZE, 8},
                   {GL_IMAGE_BINDING_NAME, 8},
                   {GL_IMAGE_BINDING_FORMAT, 8},
                   {GL_IMAGE_BINDING_ACCESS, 8},
                   {GL_BLEND_SRC_RGB, 8},
                   {GL_BLEND_SRC_ALPHA, 8},
                   {GL_BLEND_DST_RGB, 8},
                   {GL_BLEND_DST_ALPHA, 8},
                   {GL_BLEND_EQUATION_RGB, 8},
                   {GL_BLEND_EQUATION_ALPHA, 8}};
    numbers->count = 0;
    for (size_t i = 0; i < COUNT(plain); i++)
        add_integer(numbers, plain[i]);
    for (size_t i = 0; i < COUNT(indexed); i++)
        add_indexed(numbers, indexed[i].name, indexed[i].count);
    for (size_t i = 0; i < COUNT(capabilities); i++)
        add(numbers, gl_.IsEnabled(capabilities[i]));
    for (GLuint i = 0; i < 8; i++) {
        GLint mask[4];
        gl_.GetIntegeri_v(GL_COLOR_WRITEMASK, i, mask);
        for (int c = 0; c < 4; c++)
            add(numbers, mask[c]);
        add(numbers, gl_.IsEnabledi(GL_BLEND, i));
    }
    for (GLuint i = 0; i < 16; i++) {
        GLfloat viewport[4];
        GLdouble depth[2];
        gl_.GetFloati_v(GL_VIEWPORT, i, viewport);
        gl_.GetDoublei_v(GL_DEPTH_RANGE, i, depth);
        for (int c = 0; c < 4; c++)
            add(numbers, (double)viewport[c]);
        add(numbers, depth[0]);
        add(numbers, depth[1]);
        add(numbers, gl_.IsEnabledi(GL_SCISSOR_TEST, i));
    }
    GLint unit, feedback;
    gl_.GetIntegerv(GL_ACTIVE_TEXTURE, &unit);
    gl_.GetIntegerv(GL_TRANSFORM_FEEDBACK_BINDING, &feedback);
    for (GLuint i = 0; i < UNITS; i++) {
        static const GLenum names[] = {GL_TEXTURE_BINDING_2D, GL_TEXTURE_BINDING_2D_ARRAY,
                                       GL_TEXTURE_BINDING_3D, GL_TEXTURE_BINDING_BUFFER,
                                       GL_SAMPLER_BINDING};
        gl_.ActiveTexture(GL_TEXTURE0 + i);
        for (size_t k = 0; k < COUNT(names); k++) {
            GLint name = 0;
            gl_.GetIntegerv(names[k], &name);
            add(numbers, name);
        }
    }
    gl_.ActiveTexture((GLenum)unit);
    gl_.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, 0);
    add_indexed(numbers, GL_TRANSFORM_FEEDBACK_BUFFER_BINDING, 4);
    add_indexed(numbers, GL_TRANSFORM_FEEDBACK_BUFFER_START, 4);
    gl_.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, (GLuint)feedback);
}

static struct numbers before, after;

static void shuffle(unsigned with) {
    seed = with;
    shuffle_bindings();
    shuffle_modes();
    while (gl_.GetError() != GL_NO_ERROR)
        ;
    read_state(&before);
}

static void check_state(const char *what) {
    read_state(&after);
    assert_int_equal(before.count, after.count);
    for (size_t i = 0; i < before.count; i++)
        if (before.values[i] != after.values[i])
            printf("    %s: number %zu was %g and is %g\n", what, i, before.values[i],
                   after.values[i]);
    assert_memory_equal(before.values, after.values, before.count * sizeof *before.values);
}

/* Whatever state the caller has, the picture is the same, and the state after each call is that of
 * before. Screen passes are drawn and dispatched in turn. */
TEST(state_stays) {
    need_host();
    load_functions();
    assert_int_equal(make_current(NULL), 0);
    make_objects();
    struct manylight_scene *scene = open_scene("scenes/gloss.glb");
    struct manylight_device *own = open_device();
    const struct manylight_renderer_desc desc = {
        .size = sizeof desc, .width = 48, .height = 40, .passes = 2};
    struct manylight_image *expected = draw_once(own, scene, &desc, NULL), *image;
    for (unsigned i = 1; i <= (is_long_run() ? 20 : 2); i++) {
        struct manylight_renderer *renderer;
        uint32_t texture;
        int width, height;
        screen_set_way(i % 2 ? SCREEN_COMPUTE : SCREEN_FRAGMENT);
        shuffle(i);
        struct manylight_device *device = adopt(&kept_current);
        check_state("device_create");
        shuffle(100 + i);
        check_call("create", manylight_renderer_create(device, scene, &desc, &renderer));
        check_state("renderer_create");
        shuffle(200 + i);
        check_call("render", manylight_render(renderer, NULL));
        check_state("render");
        shuffle(300 + i);
        check_call("read", manylight_read(renderer, NULL, &image));
        check_call("texture", manylight_display_texture(renderer, NULL, &texture, &width, &height));
        check_state("read");
        assert_true(gl_.IsTexture(texture) && width == 48 && height == 40);
        assert_true(same_images(expected, image));
        shuffle(400 + i);
        manylight_renderer_free(renderer);
        manylight_device_free(device);
        check_state("free");
        assert_int_equal(gl_.GetError(), GL_NO_ERROR);
        manylight_image_free(image);
    }
    screen_set_way(SCREEN_AUTO);
    printf("    %zu numbers of state\n", before.count);
    manylight_image_free(expected);
    manylight_scene_free(scene);
    manylight_device_free(own);
    release_current(NULL);
}

/* --- objects ---------------------------------------------------------------------------------- */

/* Objects of the context, of names up to a bound. Drivers give new names to what is made anew. */
static int count_objects(void) {
    int count = 0;
    for (GLuint name = 1; name < (is_long_run() ? 100000 : 3000); name++)
        count += gl_.IsTexture(name) + gl_.IsBuffer(name) + gl_.IsProgram(name) +
                 gl_.IsFramebuffer(name) + gl_.IsVertexArray(name) + gl_.IsQuery(name);
    return count;
}

TEST(objects_go) {
    need_host();
    load_functions();
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
