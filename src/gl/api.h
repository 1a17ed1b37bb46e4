/* Table of the OpenGL functions that manylight uses: gl.CreateTextures(...).
 *
 * Each thread has one table, which belongs to its current context. context_make_current
 * (gl/context/context.h) fills it through the getproc of the context, so one binary serves EGL,
 * OSMesa and a window. To use another function, add its line to GL_FUNCTIONS. A driver that lacks a
 * listed function is refused, so `make lint` refuses functions that nobody calls. */
#ifndef GL_API_H
#define GL_API_H

#include <GL/glcorearb.h>

#include <stdbool.h>
#include <stddef.h>

/* X(type, name without gl), OpenGL 4.5 core only. */
#define GL_FUNCTIONS(X)                                                                            \
    /* Textures and images. */                                                                     \
    X(PFNGLCREATETEXTURESPROC, CreateTextures)                                                     \
    X(PFNGLDELETETEXTURESPROC, DeleteTextures)                                                     \
    X(PFNGLTEXTURESTORAGE2DPROC, TextureStorage2D)                                                 \
    X(PFNGLTEXTURESTORAGE3DPROC, TextureStorage3D)                                                 \
    X(PFNGLTEXTURESTORAGE3DMULTISAMPLEPROC, TextureStorage3DMultisample)                           \
    X(PFNGLCOPYIMAGESUBDATAPROC, CopyImageSubData)                                                 \
    X(PFNGLTEXTURESUBIMAGE2DPROC, TextureSubImage2D)                                               \
    X(PFNGLTEXTURESUBIMAGE3DPROC, TextureSubImage3D)                                               \
    X(PFNGLTEXTUREPARAMETERIPROC, TextureParameteri)                                               \
    X(PFNGLGENERATETEXTUREMIPMAPPROC, GenerateTextureMipmap)                                       \
    X(PFNGLBINDTEXTUREUNITPROC, BindTextureUnit)                                                   \
    X(PFNGLACTIVETEXTUREPROC, ActiveTexture)                                                       \
    X(PFNGLGETTEXTUREIMAGEPROC, GetTextureImage)                                                   \
    X(PFNGLGETMULTISAMPLEFVPROC, GetMultisamplefv)                                                 \
    X(PFNGLGETTEXTURESUBIMAGEPROC, GetTextureSubImage)                                             \
    X(PFNGLTEXTUREBUFFERPROC, TextureBuffer)                                                       \
    X(PFNGLCLEARTEXIMAGEPROC, ClearTexImage)                                                       \
    X(PFNGLBINDIMAGETEXTUREPROC, BindImageTexture)                                                 \
    /* Buffers. */                                                                                 \
    X(PFNGLCREATEBUFFERSPROC, CreateBuffers)                                                       \
    X(PFNGLDELETEBUFFERSPROC, DeleteBuffers)                                                       \
    X(PFNGLBINDBUFFERPROC, BindBuffer)                                                             \
    X(PFNGLBINDBUFFERBASEPROC, BindBufferBase)                                                     \
    X(PFNGLBINDBUFFERRANGEPROC, BindBufferRange)                                                   \
    X(PFNGLNAMEDBUFFERSTORAGEPROC, NamedBufferStorage)                                             \
    X(PFNGLNAMEDBUFFERSUBDATAPROC, NamedBufferSubData)                                             \
    X(PFNGLGETNAMEDBUFFERSUBDATAPROC, GetNamedBufferSubData)                                       \
    /* Vertex arrays. */                                                                           \
    X(PFNGLCREATEVERTEXARRAYSPROC, CreateVertexArrays)                                             \
    X(PFNGLDELETEVERTEXARRAYSPROC, DeleteVertexArrays)                                             \
    X(PFNGLBINDVERTEXARRAYPROC, BindVertexArray)                                                   \
    X(PFNGLVERTEXARRAYVERTEXBUFFERPROC, VertexArrayVertexBuffer)                                   \
    X(PFNGLVERTEXARRAYELEMENTBUFFERPROC, VertexArrayElementBuffer)                                 \
    X(PFNGLVERTEXARRAYATTRIBFORMATPROC, VertexArrayAttribFormat)                                   \
    X(PFNGLVERTEXARRAYATTRIBBINDINGPROC, VertexArrayAttribBinding)                                 \
    X(PFNGLENABLEVERTEXARRAYATTRIBPROC, EnableVertexArrayAttrib)                                   \
    /* Framebuffers. */                                                                            \
    X(PFNGLCREATEFRAMEBUFFERSPROC, CreateFramebuffers)                                             \
    X(PFNGLDELETEFRAMEBUFFERSPROC, DeleteFramebuffers)                                             \
    X(PFNGLBINDFRAMEBUFFERPROC, BindFramebuffer)                                                   \
    X(PFNGLNAMEDFRAMEBUFFERTEXTUREPROC, NamedFramebufferTexture)                                   \
    X(PFNGLNAMEDFRAMEBUFFERPARAMETERIPROC, NamedFramebufferParameteri)                             \
    X(PFNGLNAMEDFRAMEBUFFERDRAWBUFFERSPROC, NamedFramebufferDrawBuffers)                           \
    X(PFNGLCHECKNAMEDFRAMEBUFFERSTATUSPROC, CheckNamedFramebufferStatus)                           \
    X(PFNGLCLEARNAMEDFRAMEBUFFERFVPROC, ClearNamedFramebufferfv)                                   \
    X(PFNGLCLEARNAMEDFRAMEBUFFERUIVPROC, ClearNamedFramebufferuiv)                                 \
    /* Shaders and programs. */                                                                    \
    X(PFNGLCREATESHADERPROC, CreateShader)                                                         \
    X(PFNGLDELETESHADERPROC, DeleteShader)                                                         \
    X(PFNGLSHADERSOURCEPROC, ShaderSource)                                                         \
    X(PFNGLCOMPILESHADERPROC, CompileShader)                                                       \
    X(PFNGLGETSHADERIVPROC, GetShaderiv)                                                           \
    X(PFNGLGETSHADERINFOLOGPROC, GetShaderInfoLog)                                                 \
    X(PFNGLCREATEPROGRAMPROC, CreateProgram)                                                       \
    X(PFNGLDELETEPROGRAMPROC, DeleteProgram)                                                       \
    X(PFNGLATTACHSHADERPROC, AttachShader)                                                         \
    X(PFNGLLINKPROGRAMPROC, LinkProgram)                                                           \
    X(PFNGLGETPROGRAMIVPROC, GetProgramiv)                                                         \
    X(PFNGLGETPROGRAMINFOLOGPROC, GetProgramInfoLog)                                               \
    X(PFNGLUSEPROGRAMPROC, UseProgram)                                                             \
    X(PFNGLPROGRAMPARAMETERIPROC, ProgramParameteri)                                               \
    X(PFNGLGETPROGRAMBINARYPROC, GetProgramBinary)                                                 \
    X(PFNGLPROGRAMBINARYPROC, ProgramBinary)                                                       \
    /* Uniforms of a named program. */                                                             \
    X(PFNGLGETACTIVEUNIFORMPROC, GetActiveUniform)                                                 \
    X(PFNGLGETUNIFORMLOCATIONPROC, GetUniformLocation)                                             \
    X(PFNGLGETUNIFORMIVPROC, GetUniformiv)                                                         \
    X(PFNGLPROGRAMUNIFORM1IPROC, ProgramUniform1i)                                                 \
    X(PFNGLPROGRAMUNIFORM2IPROC, ProgramUniform2i)                                                 \
    X(PFNGLPROGRAMUNIFORM4IPROC, ProgramUniform4i)                                                 \
    X(PFNGLPROGRAMUNIFORM4FPROC, ProgramUniform4f)                                                 \
    X(PFNGLPROGRAMUNIFORM1FPROC, ProgramUniform1f)                                                 \
    X(PFNGLPROGRAMUNIFORM2FVPROC, ProgramUniform2fv)                                               \
    /* Draws and dispatches. */                                                                    \
    X(PFNGLDRAWARRAYSPROC, DrawArrays)                                                             \
    X(PFNGLDRAWARRAYSINSTANCEDPROC, DrawArraysInstanced)                                           \
    X(PFNGLDRAWELEMENTSINSTANCEDBASEVERTEXPROC, DrawElementsInstancedBaseVertex)                   \
    X(PFNGLDISPATCHCOMPUTEPROC, DispatchCompute)                                                   \
    X(PFNGLDISPATCHCOMPUTEINDIRECTPROC, DispatchComputeIndirect)                                   \
    X(PFNGLMEMORYBARRIERPROC, MemoryBarrier)                                                       \
    /* Transform feedback. */                                                                      \
    X(PFNGLBEGINTRANSFORMFEEDBACKPROC, BeginTransformFeedback)                                     \
    X(PFNGLENDTRANSFORMFEEDBACKPROC, EndTransformFeedback)                                         \
    /* State. */                                                                                   \
    X(PFNGLENABLEPROC, Enable)                                                                     \
    X(PFNGLDISABLEPROC, Disable)                                                                   \
    X(PFNGLVIEWPORTPROC, Viewport)                                                                 \
    X(PFNGLDEPTHFUNCPROC, DepthFunc)                                                               \
    X(PFNGLCULLFACEPROC, CullFace)                                                                 \
    X(PFNGLDEPTHMASKPROC, DepthMask)                                                               \
    X(PFNGLBLENDFUNCPROC, BlendFunc)                                                               \
    X(PFNGLBLENDEQUATIONPROC, BlendEquation)                                                       \
    X(PFNGLCLIPCONTROLPROC, ClipControl)                                                           \
    /* Queries. */                                                                                 \
    X(PFNGLCREATEQUERIESPROC, CreateQueries)                                                       \
    X(PFNGLDELETEQUERIESPROC, DeleteQueries)                                                       \
    X(PFNGLQUERYCOUNTERPROC, QueryCounter)                                                         \
    X(PFNGLGETQUERYIVPROC, GetQueryiv)                                                             \
    X(PFNGLGETQUERYOBJECTIVPROC, GetQueryObjectiv)                                                 \
    X(PFNGLGETQUERYOBJECTUI64VPROC, GetQueryObjectui64v)                                           \
    /* Synchronisation. */                                                                         \
    X(PFNGLFINISHPROC, Finish)                                                                     \
    /* Debugging. */                                                                               \
    X(PFNGLDEBUGMESSAGECALLBACKPROC, DebugMessageCallback)                                         \
    X(PFNGLDEBUGMESSAGECONTROLPROC, DebugMessageControl)                                           \
    X(PFNGLDEBUGMESSAGEINSERTPROC, DebugMessageInsert)                                             \
    X(PFNGLPUSHDEBUGGROUPPROC, PushDebugGroup)                                                     \
    X(PFNGLPOPDEBUGGROUPPROC, PopDebugGroup)                                                       \
    X(PFNGLOBJECTLABELPROC, ObjectLabel)                                                           \
    /* Queries of the implementation. */                                                           \
    X(PFNGLGETSTRINGPROC, GetString)                                                               \
    X(PFNGLGETSTRINGIPROC, GetStringi)                                                             \
    X(PFNGLGETERRORPROC, GetError)                                                                 \
    X(PFNGLGETGRAPHICSRESETSTATUSPROC, GetGraphicsResetStatus)                                     \
    X(PFNGLGETINTEGERVPROC, GetIntegerv)                                                           \
    X(PFNGLGETINTEGER64VPROC, GetInteger64v)

struct gl_api {
#define GL_MEMBER(type, name) type name;
    GL_FUNCTIONS(GL_MEMBER)
#undef GL_MEMBER
    /* Created with the context. The core profile draws nothing without a vertex array. Without a
     * window it also needs a framebuffer, even if nothing is rasterised. */
    GLuint empty_vertex_array, empty_framebuffer;
    struct program_cache *programs;        /* gl/program.c */
    struct framebuffer_list *framebuffers; /* gl/framebuffer.c */
    struct screen_rows *screen_rows;       /* gl/screen_rows.c */
    struct program_store *store;           /* gl/program.c; NULL: none */
    bool fills_store;                      /* linked programs are added to the store */
    struct gl_watched { /* gl/context/samplers.c: functions of the driver, in debug contexts */
        PFNGLDRAWARRAYSPROC DrawArrays;
        PFNGLDRAWARRAYSINSTANCEDPROC DrawArraysInstanced;
        PFNGLDRAWELEMENTSINSTANCEDBASEVERTEXPROC DrawElementsInstancedBaseVertex;
        PFNGLDISPATCHCOMPUTEPROC DispatchCompute;
        PFNGLDISPATCHCOMPUTEINDIRECTPROC DispatchComputeIndirect;
        int *faults;
    } watched;
    size_t memory; /* GPU memory in bytes; 0: the driver does not report it */
    bool software; /* OpenGL runs on the CPU: llvmpipe, softpipe, swrast */
};

/* Table of this thread's current context; all members NULL without a context. */
extern _Thread_local struct gl_api gl;

/* Fills api. Error: names the first function that getproc does not know. */
bool gl_api_load(struct gl_api *api, void *(*getproc)(const char *name));

/* True if the context has the extension, for example "GL_ARB_...". */
bool gl_has_extension(const struct gl_api *api, const char *name);

#endif
