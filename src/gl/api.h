/* The OpenGL functions that manylight uses, as a table: gl.CreateTextures(...).
 *
 * The table belongs to the context that is current; context_make_current (gl/context.h) fills it
 * through the context's own getproc, so that one binary serves EGL, OSMesa and a window. A function
 * that is not in the list yet gets its line in GL_FUNCTIONS. One thread uses OpenGL.
 */
#ifndef GL_API_H
#define GL_API_H

#include <GL/glcorearb.h>

#include <stdbool.h>

/* X(type, name without gl), OpenGL 4.5 core only. */
#define GL_FUNCTIONS(X)                                                                            \
    /* Textures and images. */                                                                     \
    X(PFNGLCREATETEXTURESPROC, CreateTextures)                                                     \
    X(PFNGLGENTEXTURESPROC, GenTextures)                                                           \
    X(PFNGLDELETETEXTURESPROC, DeleteTextures)                                                     \
    X(PFNGLTEXTURESTORAGE1DPROC, TextureStorage1D)                                                 \
    X(PFNGLTEXTURESTORAGE2DPROC, TextureStorage2D)                                                 \
    X(PFNGLTEXTURESTORAGE3DPROC, TextureStorage3D)                                                 \
    X(PFNGLTEXTURESTORAGE2DMULTISAMPLEPROC, TextureStorage2DMultisample)                           \
    X(PFNGLTEXTURESTORAGE3DMULTISAMPLEPROC, TextureStorage3DMultisample)                           \
    X(PFNGLTEXTURESUBIMAGE1DPROC, TextureSubImage1D)                                               \
    X(PFNGLTEXTURESUBIMAGE2DPROC, TextureSubImage2D)                                               \
    X(PFNGLTEXTURESUBIMAGE3DPROC, TextureSubImage3D)                                               \
    X(PFNGLTEXTUREPARAMETERIPROC, TextureParameteri)                                               \
    X(PFNGLTEXTUREPARAMETERFPROC, TextureParameterf)                                               \
    X(PFNGLTEXTUREPARAMETERIVPROC, TextureParameteriv)                                             \
    X(PFNGLTEXTUREPARAMETERFVPROC, TextureParameterfv)                                             \
    X(PFNGLGENERATETEXTUREMIPMAPPROC, GenerateTextureMipmap)                                       \
    X(PFNGLBINDTEXTUREUNITPROC, BindTextureUnit)                                                   \
    X(PFNGLBINDTEXTURESPROC, BindTextures)                                                         \
    X(PFNGLGETTEXTUREIMAGEPROC, GetTextureImage)                                                   \
    X(PFNGLGETMULTISAMPLEFVPROC, GetMultisamplefv)                                                 \
    X(PFNGLGETTEXTURESUBIMAGEPROC, GetTextureSubImage)                                             \
    X(PFNGLGETTEXTURELEVELPARAMETERIVPROC, GetTextureLevelParameteriv)                             \
    X(PFNGLGETTEXTUREPARAMETERIVPROC, GetTextureParameteriv)                                       \
    X(PFNGLTEXTUREVIEWPROC, TextureView)                                                           \
    X(PFNGLTEXTUREBUFFERPROC, TextureBuffer)                                                       \
    X(PFNGLTEXTUREBUFFERRANGEPROC, TextureBufferRange)                                             \
    X(PFNGLCLEARTEXIMAGEPROC, ClearTexImage)                                                       \
    X(PFNGLCLEARTEXSUBIMAGEPROC, ClearTexSubImage)                                                 \
    X(PFNGLCOPYIMAGESUBDATAPROC, CopyImageSubData)                                                 \
    X(PFNGLBINDIMAGETEXTUREPROC, BindImageTexture)                                                 \
    /* Samplers. */                                                                                \
    X(PFNGLCREATESAMPLERSPROC, CreateSamplers)                                                     \
    X(PFNGLDELETESAMPLERSPROC, DeleteSamplers)                                                     \
    X(PFNGLBINDSAMPLERPROC, BindSampler)                                                           \
    X(PFNGLBINDSAMPLERSPROC, BindSamplers)                                                         \
    X(PFNGLSAMPLERPARAMETERIPROC, SamplerParameteri)                                               \
    X(PFNGLSAMPLERPARAMETERFPROC, SamplerParameterf)                                               \
    X(PFNGLSAMPLERPARAMETERFVPROC, SamplerParameterfv)                                             \
    /* Buffers. */                                                                                 \
    X(PFNGLCREATEBUFFERSPROC, CreateBuffers)                                                       \
    X(PFNGLDELETEBUFFERSPROC, DeleteBuffers)                                                       \
    X(PFNGLBINDBUFFERPROC, BindBuffer)                                                             \
    X(PFNGLBINDBUFFERBASEPROC, BindBufferBase)                                                     \
    X(PFNGLBINDBUFFERRANGEPROC, BindBufferRange)                                                   \
    X(PFNGLNAMEDBUFFERSTORAGEPROC, NamedBufferStorage)                                             \
    X(PFNGLNAMEDBUFFERDATAPROC, NamedBufferData)                                                   \
    X(PFNGLNAMEDBUFFERSUBDATAPROC, NamedBufferSubData)                                             \
    X(PFNGLGETNAMEDBUFFERSUBDATAPROC, GetNamedBufferSubData)                                       \
    X(PFNGLGETNAMEDBUFFERPARAMETERIVPROC, GetNamedBufferParameteriv)                               \
    X(PFNGLMAPNAMEDBUFFERRANGEPROC, MapNamedBufferRange)                                           \
    X(PFNGLFLUSHMAPPEDNAMEDBUFFERRANGEPROC, FlushMappedNamedBufferRange)                           \
    X(PFNGLUNMAPNAMEDBUFFERPROC, UnmapNamedBuffer)                                                 \
    X(PFNGLCOPYNAMEDBUFFERSUBDATAPROC, CopyNamedBufferSubData)                                     \
    X(PFNGLCLEARNAMEDBUFFERDATAPROC, ClearNamedBufferData)                                         \
    X(PFNGLCLEARNAMEDBUFFERSUBDATAPROC, ClearNamedBufferSubData)                                   \
    X(PFNGLINVALIDATEBUFFERDATAPROC, InvalidateBufferData)                                         \
    /* Vertex arrays. */                                                                           \
    X(PFNGLCREATEVERTEXARRAYSPROC, CreateVertexArrays)                                             \
    X(PFNGLDELETEVERTEXARRAYSPROC, DeleteVertexArrays)                                             \
    X(PFNGLBINDVERTEXARRAYPROC, BindVertexArray)                                                   \
    X(PFNGLVERTEXARRAYVERTEXBUFFERPROC, VertexArrayVertexBuffer)                                   \
    X(PFNGLVERTEXARRAYELEMENTBUFFERPROC, VertexArrayElementBuffer)                                 \
    X(PFNGLVERTEXARRAYATTRIBFORMATPROC, VertexArrayAttribFormat)                                   \
    X(PFNGLVERTEXARRAYATTRIBIFORMATPROC, VertexArrayAttribIFormat)                                 \
    X(PFNGLVERTEXARRAYATTRIBBINDINGPROC, VertexArrayAttribBinding)                                 \
    X(PFNGLENABLEVERTEXARRAYATTRIBPROC, EnableVertexArrayAttrib)                                   \
    X(PFNGLDISABLEVERTEXARRAYATTRIBPROC, DisableVertexArrayAttrib)                                 \
    X(PFNGLVERTEXARRAYBINDINGDIVISORPROC, VertexArrayBindingDivisor)                               \
    X(PFNGLVERTEXATTRIB4FPROC, VertexAttrib4f)                                                     \
    X(PFNGLVERTEXATTRIBI4IPROC, VertexAttribI4i)                                                   \
    /* Framebuffers. */                                                                            \
    X(PFNGLCREATEFRAMEBUFFERSPROC, CreateFramebuffers)                                             \
    X(PFNGLDELETEFRAMEBUFFERSPROC, DeleteFramebuffers)                                             \
    X(PFNGLBINDFRAMEBUFFERPROC, BindFramebuffer)                                                   \
    X(PFNGLNAMEDFRAMEBUFFERTEXTUREPROC, NamedFramebufferTexture)                                   \
    X(PFNGLNAMEDFRAMEBUFFERTEXTURELAYERPROC, NamedFramebufferTextureLayer)                         \
    X(PFNGLNAMEDFRAMEBUFFERRENDERBUFFERPROC, NamedFramebufferRenderbuffer)                         \
    X(PFNGLNAMEDFRAMEBUFFERPARAMETERIPROC, NamedFramebufferParameteri)                             \
    X(PFNGLNAMEDFRAMEBUFFERDRAWBUFFERPROC, NamedFramebufferDrawBuffer)                             \
    X(PFNGLNAMEDFRAMEBUFFERDRAWBUFFERSPROC, NamedFramebufferDrawBuffers)                           \
    X(PFNGLNAMEDFRAMEBUFFERREADBUFFERPROC, NamedFramebufferReadBuffer)                             \
    X(PFNGLCHECKNAMEDFRAMEBUFFERSTATUSPROC, CheckNamedFramebufferStatus)                           \
    X(PFNGLBLITNAMEDFRAMEBUFFERPROC, BlitNamedFramebuffer)                                         \
    X(PFNGLCLEARNAMEDFRAMEBUFFERFVPROC, ClearNamedFramebufferfv)                                   \
    X(PFNGLCLEARNAMEDFRAMEBUFFERIVPROC, ClearNamedFramebufferiv)                                   \
    X(PFNGLCLEARNAMEDFRAMEBUFFERUIVPROC, ClearNamedFramebufferuiv)                                 \
    X(PFNGLCLEARNAMEDFRAMEBUFFERFIPROC, ClearNamedFramebufferfi)                                   \
    X(PFNGLINVALIDATENAMEDFRAMEBUFFERDATAPROC, InvalidateNamedFramebufferData)                     \
    X(PFNGLCREATERENDERBUFFERSPROC, CreateRenderbuffers)                                           \
    X(PFNGLDELETERENDERBUFFERSPROC, DeleteRenderbuffers)                                           \
    X(PFNGLNAMEDRENDERBUFFERSTORAGEPROC, NamedRenderbufferStorage)                                 \
    X(PFNGLREADBUFFERPROC, ReadBuffer)                                                             \
    X(PFNGLREADPIXELSPROC, ReadPixels)                                                             \
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
    X(PFNGLDETACHSHADERPROC, DetachShader)                                                         \
    X(PFNGLBINDATTRIBLOCATIONPROC, BindAttribLocation)                                             \
    X(PFNGLBINDFRAGDATALOCATIONPROC, BindFragDataLocation)                                         \
    X(PFNGLTRANSFORMFEEDBACKVARYINGSPROC, TransformFeedbackVaryings)                               \
    X(PFNGLLINKPROGRAMPROC, LinkProgram)                                                           \
    X(PFNGLVALIDATEPROGRAMPROC, ValidateProgram)                                                   \
    X(PFNGLGETPROGRAMIVPROC, GetProgramiv)                                                         \
    X(PFNGLGETPROGRAMINFOLOGPROC, GetProgramInfoLog)                                               \
    X(PFNGLUSEPROGRAMPROC, UseProgram)                                                             \
    X(PFNGLGETATTRIBLOCATIONPROC, GetAttribLocation)                                               \
    X(PFNGLGETFRAGDATALOCATIONPROC, GetFragDataLocation)                                           \
    /* Program interfaces. */                                                                      \
    X(PFNGLGETUNIFORMLOCATIONPROC, GetUniformLocation)                                             \
    X(PFNGLGETACTIVEUNIFORMPROC, GetActiveUniform)                                                 \
    X(PFNGLGETACTIVEUNIFORMNAMEPROC, GetActiveUniformName)                                         \
    X(PFNGLGETACTIVEUNIFORMSIVPROC, GetActiveUniformsiv)                                           \
    X(PFNGLGETUNIFORMINDICESPROC, GetUniformIndices)                                               \
    X(PFNGLGETUNIFORMBLOCKINDEXPROC, GetUniformBlockIndex)                                         \
    X(PFNGLGETACTIVEUNIFORMBLOCKIVPROC, GetActiveUniformBlockiv)                                   \
    X(PFNGLGETACTIVEUNIFORMBLOCKNAMEPROC, GetActiveUniformBlockName)                               \
    X(PFNGLUNIFORMBLOCKBINDINGPROC, UniformBlockBinding)                                           \
    X(PFNGLSHADERSTORAGEBLOCKBINDINGPROC, ShaderStorageBlockBinding)                               \
    X(PFNGLGETPROGRAMINTERFACEIVPROC, GetProgramInterfaceiv)                                       \
    X(PFNGLGETPROGRAMRESOURCEINDEXPROC, GetProgramResourceIndex)                                   \
    X(PFNGLGETPROGRAMRESOURCENAMEPROC, GetProgramResourceName)                                     \
    X(PFNGLGETPROGRAMRESOURCEIVPROC, GetProgramResourceiv)                                         \
    X(PFNGLGETPROGRAMRESOURCELOCATIONPROC, GetProgramResourceLocation)                             \
    X(PFNGLGETUNIFORMIVPROC, GetUniformiv)                                                         \
    X(PFNGLGETUNIFORMFVPROC, GetUniformfv)                                                         \
    /* Uniforms of the current program. */                                                         \
    X(PFNGLUNIFORM1IPROC, Uniform1i)                                                               \
    X(PFNGLUNIFORM2IPROC, Uniform2i)                                                               \
    X(PFNGLUNIFORM3IPROC, Uniform3i)                                                               \
    X(PFNGLUNIFORM4IPROC, Uniform4i)                                                               \
    X(PFNGLUNIFORM1IVPROC, Uniform1iv)                                                             \
    X(PFNGLUNIFORM1UIPROC, Uniform1ui)                                                             \
    X(PFNGLUNIFORM2UIPROC, Uniform2ui)                                                             \
    X(PFNGLUNIFORM3UIPROC, Uniform3ui)                                                             \
    X(PFNGLUNIFORM4UIPROC, Uniform4ui)                                                             \
    X(PFNGLUNIFORM1FPROC, Uniform1f)                                                               \
    X(PFNGLUNIFORM2FPROC, Uniform2f)                                                               \
    X(PFNGLUNIFORM3FPROC, Uniform3f)                                                               \
    X(PFNGLUNIFORM4FPROC, Uniform4f)                                                               \
    X(PFNGLUNIFORM1FVPROC, Uniform1fv)                                                             \
    X(PFNGLUNIFORM2FVPROC, Uniform2fv)                                                             \
    X(PFNGLUNIFORM3FVPROC, Uniform3fv)                                                             \
    X(PFNGLUNIFORM4FVPROC, Uniform4fv)                                                             \
    X(PFNGLUNIFORMMATRIX3FVPROC, UniformMatrix3fv)                                                 \
    X(PFNGLUNIFORMMATRIX4FVPROC, UniformMatrix4fv)                                                 \
    /* Uniforms of a named program. */                                                             \
    X(PFNGLPROGRAMUNIFORM1IPROC, ProgramUniform1i)                                                 \
    X(PFNGLPROGRAMUNIFORM2IPROC, ProgramUniform2i)                                                 \
    X(PFNGLPROGRAMUNIFORM3IPROC, ProgramUniform3i)                                                 \
    X(PFNGLPROGRAMUNIFORM4IPROC, ProgramUniform4i)                                                 \
    X(PFNGLPROGRAMUNIFORM1IVPROC, ProgramUniform1iv)                                               \
    X(PFNGLPROGRAMUNIFORM1UIPROC, ProgramUniform1ui)                                               \
    X(PFNGLPROGRAMUNIFORM2UIPROC, ProgramUniform2ui)                                               \
    X(PFNGLPROGRAMUNIFORM3UIPROC, ProgramUniform3ui)                                               \
    X(PFNGLPROGRAMUNIFORM4UIPROC, ProgramUniform4ui)                                               \
    X(PFNGLPROGRAMUNIFORM1FPROC, ProgramUniform1f)                                                 \
    X(PFNGLPROGRAMUNIFORM2FPROC, ProgramUniform2f)                                                 \
    X(PFNGLPROGRAMUNIFORM3FPROC, ProgramUniform3f)                                                 \
    X(PFNGLPROGRAMUNIFORM4FPROC, ProgramUniform4f)                                                 \
    X(PFNGLPROGRAMUNIFORM1FVPROC, ProgramUniform1fv)                                               \
    X(PFNGLPROGRAMUNIFORM2FVPROC, ProgramUniform2fv)                                               \
    X(PFNGLPROGRAMUNIFORM3FVPROC, ProgramUniform3fv)                                               \
    X(PFNGLPROGRAMUNIFORM4FVPROC, ProgramUniform4fv)                                               \
    X(PFNGLPROGRAMUNIFORMMATRIX3FVPROC, ProgramUniformMatrix3fv)                                   \
    X(PFNGLPROGRAMUNIFORMMATRIX4FVPROC, ProgramUniformMatrix4fv)                                   \
    /* Draws and dispatches. */                                                                    \
    X(PFNGLDRAWARRAYSPROC, DrawArrays)                                                             \
    X(PFNGLDRAWARRAYSINSTANCEDPROC, DrawArraysInstanced)                                           \
    X(PFNGLDRAWARRAYSINSTANCEDBASEINSTANCEPROC, DrawArraysInstancedBaseInstance)                   \
    X(PFNGLDRAWARRAYSINDIRECTPROC, DrawArraysIndirect)                                             \
    X(PFNGLDRAWELEMENTSPROC, DrawElements)                                                         \
    X(PFNGLDRAWELEMENTSINSTANCEDPROC, DrawElementsInstanced)                                       \
    X(PFNGLDRAWELEMENTSINSTANCEDBASEINSTANCEPROC, DrawElementsInstancedBaseInstance)               \
    X(PFNGLDRAWELEMENTSBASEVERTEXPROC, DrawElementsBaseVertex)                                     \
    X(PFNGLDRAWELEMENTSINSTANCEDBASEVERTEXPROC, DrawElementsInstancedBaseVertex)                   \
    X(PFNGLDRAWELEMENTSINSTANCEDBASEVERTEXBASEINSTANCEPROC,                                        \
      DrawElementsInstancedBaseVertexBaseInstance)                                                 \
    X(PFNGLDRAWELEMENTSINDIRECTPROC, DrawElementsIndirect)                                         \
    X(PFNGLMULTIDRAWARRAYSPROC, MultiDrawArrays)                                                   \
    X(PFNGLMULTIDRAWARRAYSINDIRECTPROC, MultiDrawArraysIndirect)                                   \
    X(PFNGLMULTIDRAWELEMENTSPROC, MultiDrawElements)                                               \
    X(PFNGLMULTIDRAWELEMENTSBASEVERTEXPROC, MultiDrawElementsBaseVertex)                           \
    X(PFNGLMULTIDRAWELEMENTSINDIRECTPROC, MultiDrawElementsIndirect)                               \
    X(PFNGLDISPATCHCOMPUTEPROC, DispatchCompute)                                                   \
    X(PFNGLDISPATCHCOMPUTEINDIRECTPROC, DispatchComputeIndirect)                                   \
    X(PFNGLMEMORYBARRIERPROC, MemoryBarrier)                                                       \
    X(PFNGLMEMORYBARRIERBYREGIONPROC, MemoryBarrierByRegion)                                       \
    X(PFNGLTEXTUREBARRIERPROC, TextureBarrier)                                                     \
    /* Transform feedback. */                                                                      \
    X(PFNGLCREATETRANSFORMFEEDBACKSPROC, CreateTransformFeedbacks)                                 \
    X(PFNGLDELETETRANSFORMFEEDBACKSPROC, DeleteTransformFeedbacks)                                 \
    X(PFNGLTRANSFORMFEEDBACKBUFFERBASEPROC, TransformFeedbackBufferBase)                           \
    X(PFNGLTRANSFORMFEEDBACKBUFFERRANGEPROC, TransformFeedbackBufferRange)                         \
    X(PFNGLBINDTRANSFORMFEEDBACKPROC, BindTransformFeedback)                                       \
    X(PFNGLBEGINTRANSFORMFEEDBACKPROC, BeginTransformFeedback)                                     \
    X(PFNGLENDTRANSFORMFEEDBACKPROC, EndTransformFeedback)                                         \
    X(PFNGLDRAWTRANSFORMFEEDBACKPROC, DrawTransformFeedback)                                       \
    X(PFNGLDRAWTRANSFORMFEEDBACKINSTANCEDPROC, DrawTransformFeedbackInstanced)                     \
    /* State. */                                                                                   \
    X(PFNGLENABLEPROC, Enable)                                                                     \
    X(PFNGLDISABLEPROC, Disable)                                                                   \
    X(PFNGLENABLEIPROC, Enablei)                                                                   \
    X(PFNGLDISABLEIPROC, Disablei)                                                                 \
    X(PFNGLISENABLEDPROC, IsEnabled)                                                               \
    X(PFNGLVIEWPORTPROC, Viewport)                                                                 \
    X(PFNGLVIEWPORTINDEXEDFPROC, ViewportIndexedf)                                                 \
    X(PFNGLVIEWPORTARRAYVPROC, ViewportArrayv)                                                     \
    X(PFNGLSCISSORPROC, Scissor)                                                                   \
    X(PFNGLSCISSORINDEXEDPROC, ScissorIndexed)                                                     \
    X(PFNGLDEPTHFUNCPROC, DepthFunc)                                                               \
    X(PFNGLDEPTHMASKPROC, DepthMask)                                                               \
    X(PFNGLDEPTHRANGEPROC, DepthRange)                                                             \
    X(PFNGLDEPTHRANGEFPROC, DepthRangef)                                                           \
    X(PFNGLCOLORMASKPROC, ColorMask)                                                               \
    X(PFNGLCOLORMASKIPROC, ColorMaski)                                                             \
    X(PFNGLBLENDFUNCPROC, BlendFunc)                                                               \
    X(PFNGLBLENDFUNCIPROC, BlendFunci)                                                             \
    X(PFNGLBLENDFUNCSEPARATEPROC, BlendFuncSeparate)                                               \
    X(PFNGLBLENDFUNCSEPARATEIPROC, BlendFuncSeparatei)                                             \
    X(PFNGLBLENDEQUATIONPROC, BlendEquation)                                                       \
    X(PFNGLBLENDEQUATIONIPROC, BlendEquationi)                                                     \
    X(PFNGLBLENDEQUATIONSEPARATEPROC, BlendEquationSeparate)                                       \
    X(PFNGLBLENDCOLORPROC, BlendColor)                                                             \
    X(PFNGLSTENCILFUNCPROC, StencilFunc)                                                           \
    X(PFNGLSTENCILOPPROC, StencilOp)                                                               \
    X(PFNGLSTENCILMASKPROC, StencilMask)                                                           \
    X(PFNGLCULLFACEPROC, CullFace)                                                                 \
    X(PFNGLFRONTFACEPROC, FrontFace)                                                               \
    X(PFNGLPOLYGONMODEPROC, PolygonMode)                                                           \
    X(PFNGLPOLYGONOFFSETPROC, PolygonOffset)                                                       \
    X(PFNGLPOINTSIZEPROC, PointSize)                                                               \
    X(PFNGLPOINTPARAMETERIPROC, PointParameteri)                                                   \
    X(PFNGLLINEWIDTHPROC, LineWidth)                                                               \
    X(PFNGLCLIPCONTROLPROC, ClipControl)                                                           \
    X(PFNGLPATCHPARAMETERIPROC, PatchParameteri)                                                   \
    X(PFNGLPIXELSTOREIPROC, PixelStorei)                                                           \
    X(PFNGLLOGICOPPROC, LogicOp)                                                                   \
    X(PFNGLPROVOKINGVERTEXPROC, ProvokingVertex)                                                   \
    X(PFNGLSAMPLEMASKIPROC, SampleMaski)                                                           \
    X(PFNGLMINSAMPLESHADINGPROC, MinSampleShading)                                                 \
    X(PFNGLHINTPROC, Hint)                                                                         \
    X(PFNGLCLEARPROC, Clear)                                                                       \
    X(PFNGLCLEARCOLORPROC, ClearColor)                                                             \
    X(PFNGLCLEARDEPTHPROC, ClearDepth)                                                             \
    X(PFNGLCLEARSTENCILPROC, ClearStencil)                                                         \
    /* Queries. */                                                                                 \
    X(PFNGLCREATEQUERIESPROC, CreateQueries)                                                       \
    X(PFNGLGENQUERIESPROC, GenQueries)                                                             \
    X(PFNGLDELETEQUERIESPROC, DeleteQueries)                                                       \
    X(PFNGLQUERYCOUNTERPROC, QueryCounter)                                                         \
    X(PFNGLBEGINQUERYPROC, BeginQuery)                                                             \
    X(PFNGLENDQUERYPROC, EndQuery)                                                                 \
    X(PFNGLGETQUERYIVPROC, GetQueryiv)                                                             \
    X(PFNGLGETQUERYOBJECTIVPROC, GetQueryObjectiv)                                                 \
    X(PFNGLGETQUERYOBJECTUIVPROC, GetQueryObjectuiv)                                               \
    X(PFNGLGETQUERYOBJECTI64VPROC, GetQueryObjecti64v)                                             \
    X(PFNGLGETQUERYOBJECTUI64VPROC, GetQueryObjectui64v)                                           \
    /* Synchronisation. */                                                                         \
    X(PFNGLFENCESYNCPROC, FenceSync)                                                               \
    X(PFNGLCLIENTWAITSYNCPROC, ClientWaitSync)                                                     \
    X(PFNGLWAITSYNCPROC, WaitSync)                                                                 \
    X(PFNGLDELETESYNCPROC, DeleteSync)                                                             \
    X(PFNGLFLUSHPROC, Flush)                                                                       \
    X(PFNGLFINISHPROC, Finish)                                                                     \
    /* Debugging. */                                                                               \
    X(PFNGLDEBUGMESSAGECALLBACKPROC, DebugMessageCallback)                                         \
    X(PFNGLDEBUGMESSAGECONTROLPROC, DebugMessageControl)                                           \
    X(PFNGLDEBUGMESSAGEINSERTPROC, DebugMessageInsert)                                             \
    X(PFNGLPUSHDEBUGGROUPPROC, PushDebugGroup)                                                     \
    X(PFNGLPOPDEBUGGROUPPROC, PopDebugGroup)                                                       \
    X(PFNGLOBJECTLABELPROC, ObjectLabel)                                                           \
    X(PFNGLGETOBJECTLABELPROC, GetObjectLabel)                                                     \
    /* What the implementation is. */                                                              \
    X(PFNGLGETSTRINGPROC, GetString)                                                               \
    X(PFNGLGETSTRINGIPROC, GetStringi)                                                             \
    X(PFNGLGETERRORPROC, GetError)                                                                 \
    X(PFNGLGETGRAPHICSRESETSTATUSPROC, GetGraphicsResetStatus)                                     \
    X(PFNGLGETBOOLEANVPROC, GetBooleanv)                                                           \
    X(PFNGLGETINTEGERVPROC, GetIntegerv)                                                           \
    X(PFNGLGETINTEGERI_VPROC, GetIntegeri_v)                                                       \
    X(PFNGLGETINTEGER64VPROC, GetInteger64v)                                                       \
    X(PFNGLGETFLOATVPROC, GetFloatv)                                                               \
    X(PFNGLGETFLOATI_VPROC, GetFloati_v)                                                           \
    X(PFNGLGETINTERNALFORMATIVPROC, GetInternalformativ)

struct gl_api {
#define GL_MEMBER(type, name) type name;
    GL_FUNCTIONS(GL_MEMBER)
#undef GL_MEMBER
    /* Made with the context: core profile draws nothing without a vertex array, nor, without a
     * window, without a framebuffer, even where no attribute is read and nothing is rasterised. */
    GLuint empty_vertex_array, empty_framebuffer;
    struct program_cache *programs; /* gl/program.c */
};

/* Of the current context; all NULL while there is none. */
extern struct gl_api gl;

/* Fills api. Error: names the first function that getproc does not know. */
bool gl_api_load(struct gl_api *api, void *(*getproc)(const char *name));

/* Whether the current context has an extension ("GL_ARB_..."). */
bool gl_has_extension(const char *name);

#endif
