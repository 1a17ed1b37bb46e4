#include "library/host_state.h"

#include "base/error.h"
#include "base/memory.h"

#include <GL/glcorearb.h>

#include <stdlib.h>
#include <string.h>

/* The functions that the renderer itself does not call (gl/api.h). */
#define STATE_FUNCTIONS(X)                                                                         \
    X(PFNGLGETERRORPROC, GetError)                                                                 \
    X(PFNGLGETINTEGERVPROC, GetIntegerv)                                                           \
    X(PFNGLGETFLOATVPROC, GetFloatv)                                                               \
    X(PFNGLGETINTEGERI_VPROC, GetIntegeri_v)                                                       \
    X(PFNGLGETINTEGER64I_VPROC, GetInteger64i_v)                                                   \
    X(PFNGLGETFLOATI_VPROC, GetFloati_v)                                                           \
    X(PFNGLGETDOUBLEI_VPROC, GetDoublei_v)                                                         \
    X(PFNGLGETBOOLEANI_VPROC, GetBooleani_v)                                                       \
    X(PFNGLISENABLEDPROC, IsEnabled)                                                               \
    X(PFNGLISENABLEDIPROC, IsEnabledi)                                                             \
    X(PFNGLENABLEPROC, Enable)                                                                     \
    X(PFNGLDISABLEPROC, Disable)                                                                   \
    X(PFNGLENABLEIPROC, Enablei)                                                                   \
    X(PFNGLDISABLEIPROC, Disablei)                                                                 \
    X(PFNGLACTIVETEXTUREPROC, ActiveTexture)                                                       \
    X(PFNGLBINDTEXTUREUNITPROC, BindTextureUnit)                                                   \
    X(PFNGLBINDSAMPLERPROC, BindSampler)                                                           \
    X(PFNGLBINDIMAGETEXTUREPROC, BindImageTexture)                                                 \
    X(PFNGLBINDBUFFERPROC, BindBuffer)                                                             \
    X(PFNGLBINDBUFFERBASEPROC, BindBufferBase)                                                     \
    X(PFNGLBINDBUFFERRANGEPROC, BindBufferRange)                                                   \
    X(PFNGLBINDTRANSFORMFEEDBACKPROC, BindTransformFeedback)                                       \
    X(PFNGLBINDFRAMEBUFFERPROC, BindFramebuffer)                                                   \
    X(PFNGLBINDVERTEXARRAYPROC, BindVertexArray)                                                   \
    X(PFNGLUSEPROGRAMPROC, UseProgram)                                                             \
    X(PFNGLVIEWPORTINDEXEDFPROC, ViewportIndexedf)                                                 \
    X(PFNGLDEPTHRANGEPROC, DepthRange)                                                             \
    X(PFNGLDEPTHRANGEINDEXEDPROC, DepthRangeIndexed)                                               \
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
    X(PFNGLPIXELSTOREIPROC, PixelStorei)

/* Numbers of shared/bindings.h are below; OpenGL promises so many draw buffers, viewports and image
 * units. */
enum {
    UNITS = 96,
    IMAGES = 8,
    BLOCKS = 16,
    STORAGES = 8,
    FEEDBACKS = 4,
    DRAW_BUFFERS = 8,
    VIEWPORTS = 16
};

/* What is on for passes; all else is off. */
static const struct capability {
    GLenum name;
    bool on;
} capabilities[] = {
    {GL_DEPTH_TEST, false},
    {GL_STENCIL_TEST, false},
    {GL_CULL_FACE, false},
    {GL_DITHER, false}, /* as gl/context/context.c has it */
    {GL_MULTISAMPLE, true},
    {GL_POLYGON_OFFSET_FILL, false},
    {GL_POLYGON_OFFSET_LINE, false},
    {GL_POLYGON_OFFSET_POINT, false},
    {GL_COLOR_LOGIC_OP, false},
    {GL_SAMPLE_ALPHA_TO_COVERAGE, false},
    {GL_SAMPLE_ALPHA_TO_ONE, false},
    {GL_SAMPLE_COVERAGE, false},
    {GL_SAMPLE_MASK, false},
    {GL_SAMPLE_SHADING, false},
    {GL_PRIMITIVE_RESTART, false},
    {GL_PRIMITIVE_RESTART_FIXED_INDEX, false},
    {GL_DEPTH_CLAMP, false},
    {GL_FRAMEBUFFER_SRGB, false},
    {GL_RASTERIZER_DISCARD, false},
    {GL_LINE_SMOOTH, false},
    {GL_POLYGON_SMOOTH, false},
    {GL_PROGRAM_POINT_SIZE, false},
    {GL_TEXTURE_CUBE_MAP_SEAMLESS, false},
    {GL_CLIP_DISTANCE0, false},
    {GL_CLIP_DISTANCE1, false},
    {GL_CLIP_DISTANCE2, false},
    {GL_CLIP_DISTANCE3, false},
    {GL_CLIP_DISTANCE4, false},
    {GL_CLIP_DISTANCE5, false},
    {GL_CLIP_DISTANCE6, false},
    {GL_CLIP_DISTANCE7, false},
};

static const struct storage {
    GLenum name;
    GLint standard;
} storage[] = {
    {GL_PACK_SWAP_BYTES, 0},   {GL_PACK_LSB_FIRST, 0},     {GL_PACK_ROW_LENGTH, 0},
    {GL_PACK_IMAGE_HEIGHT, 0}, {GL_PACK_SKIP_ROWS, 0},     {GL_PACK_SKIP_PIXELS, 0},
    {GL_PACK_SKIP_IMAGES, 0},  {GL_PACK_ALIGNMENT, 4},     {GL_UNPACK_SWAP_BYTES, 0},
    {GL_UNPACK_LSB_FIRST, 0},  {GL_UNPACK_ROW_LENGTH, 0},  {GL_UNPACK_IMAGE_HEIGHT, 0},
    {GL_UNPACK_SKIP_ROWS, 0},  {GL_UNPACK_SKIP_PIXELS, 0}, {GL_UNPACK_SKIP_IMAGES, 0},
    {GL_UNPACK_ALIGNMENT, 4},
};

static const GLenum texture_bindings[] = {
    GL_TEXTURE_BINDING_1D,
    GL_TEXTURE_BINDING_2D,
    GL_TEXTURE_BINDING_3D,
    GL_TEXTURE_BINDING_1D_ARRAY,
    GL_TEXTURE_BINDING_2D_ARRAY,
    GL_TEXTURE_BINDING_RECTANGLE,
    GL_TEXTURE_BINDING_BUFFER,
    GL_TEXTURE_BINDING_CUBE_MAP,
    GL_TEXTURE_BINDING_CUBE_MAP_ARRAY,
    GL_TEXTURE_BINDING_2D_MULTISAMPLE,
    GL_TEXTURE_BINDING_2D_MULTISAMPLE_ARRAY,
};

enum {
    CAPABILITIES = sizeof capabilities / sizeof *capabilities,
    STORAGE_ROWS = sizeof storage / sizeof *storage,
    TARGETS = sizeof texture_bindings / sizeof *texture_bindings,
};

struct range {
    GLint buffer;
    GLint64 start, size; /* size 0: all of it */
};

struct host_state {
#define MEMBER(type, name) type name;
    STATE_FUNCTIONS(MEMBER)
#undef MEMBER
    bool enabled[CAPABILITIES];
    GLint stored[STORAGE_ROWS];
    GLint textures[UNITS][TARGETS], samplers[UNITS], active_unit;
    struct {
        GLint texture, level, layered, layer, access, format;
    } images[IMAGES];
    struct range blocks[BLOCKS], storages[STORAGES], feedbacks[FEEDBACKS];
    GLint block, storage, indirect, feedback, feedback_object, pack_buffer, unpack_buffer;
    struct {
        bool blends;
        GLint source_rgb, source_alpha, target_rgb, target_alpha, equation_rgb, equation_alpha;
        GLboolean mask[4];
    } draw_buffers[DRAW_BUFFERS];
    struct {
        bool scissors;
        GLfloat viewport[4];
        GLdouble depth[2];
    } viewports[VIEWPORTS];
    GLint draw_framebuffer, read_framebuffer, vertex_array, program;
    GLint depth_mask, depth_func, cull_face, front_face, polygon_mode[2], clip_origin, clip_depth;
    GLint provoking_vertex;
    GLfloat point_size;
};

struct host_state *host_state_create(void *(*getproc)(const char *name)) {
    struct host_state *state = mem_alloc(1, sizeof *state);
    const char *missing = NULL;
    void *found;
#define FIND(type, name)                                                                           \
    found = getproc("gl" #name);                                                                   \
    memcpy(&state->name, &found, sizeof found);                                                    \
    if (!found && !missing)                                                                        \
        missing = "gl" #name;
    STATE_FUNCTIONS(FIND)
#undef FIND
    if (!missing)
        return state;
    free(state);
    error_set("no function %s", missing);
    return NULL;
}

void host_state_free(struct host_state *state) {
    free(state);
}

static GLint get(const struct host_state *state, GLenum name) {
    GLint values[4] = {0};
    state->GetIntegerv(name, values);
    return values[0];
}

static GLint get_at(const struct host_state *state, GLenum name, GLuint i) {
    GLint values[4] = {0};
    state->GetIntegeri_v(name, i, values);
    return values[0];
}

/* --- saving ----------------------------------------------------------------------------------- */

static void save_textures(struct host_state *state) {
    state->active_unit = get(state, GL_ACTIVE_TEXTURE);
    for (GLuint unit = 0; unit < UNITS; unit++) {
        state->ActiveTexture(GL_TEXTURE0 + unit);
        for (int i = 0; i < TARGETS; i++)
            state->textures[unit][i] = get(state, texture_bindings[i]);
        state->samplers[unit] = get(state, GL_SAMPLER_BINDING);
    }
    for (GLuint i = 0; i < IMAGES; i++) {
        state->images[i].texture = get_at(state, GL_IMAGE_BINDING_NAME, i);
        state->images[i].level = get_at(state, GL_IMAGE_BINDING_LEVEL, i);
        state->images[i].layered = get_at(state, GL_IMAGE_BINDING_LAYERED, i);
        state->images[i].layer = get_at(state, GL_IMAGE_BINDING_LAYER, i);
        state->images[i].access = get_at(state, GL_IMAGE_BINDING_ACCESS, i);
        state->images[i].format = get_at(state, GL_IMAGE_BINDING_FORMAT, i);
    }
}

static void save_ranges(const struct host_state *state, struct range *ranges, GLuint count,
                        GLenum binding, GLenum start, GLenum size) {
    for (GLuint i = 0; i < count; i++) {
        ranges[i] = (struct range){.buffer = get_at(state, binding, i)};
        state->GetInteger64i_v(start, i, &ranges[i].start);
        state->GetInteger64i_v(size, i, &ranges[i].size);
    }
}

static void save_buffers(struct host_state *state) {
    state->block = get(state, GL_UNIFORM_BUFFER_BINDING);
    state->storage = get(state, GL_SHADER_STORAGE_BUFFER_BINDING);
    state->indirect = get(state, GL_DISPATCH_INDIRECT_BUFFER_BINDING);
    state->feedback_object = get(state, GL_TRANSFORM_FEEDBACK_BINDING);
    state->pack_buffer = get(state, GL_PIXEL_PACK_BUFFER_BINDING);
    state->unpack_buffer = get(state, GL_PIXEL_UNPACK_BUFFER_BINDING);
    save_ranges(state, state->blocks, BLOCKS, GL_UNIFORM_BUFFER_BINDING, GL_UNIFORM_BUFFER_START,
                GL_UNIFORM_BUFFER_SIZE);
    save_ranges(state, state->storages, STORAGES, GL_SHADER_STORAGE_BUFFER_BINDING,
                GL_SHADER_STORAGE_BUFFER_START, GL_SHADER_STORAGE_BUFFER_SIZE);
    /* Passes use the object without a name. */
    state->BindTransformFeedback(GL_TRANSFORM_FEEDBACK, 0);
    state->feedback = get(state, GL_TRANSFORM_FEEDBACK_BUFFER_BINDING);
    save_ranges(state, state->feedbacks, FEEDBACKS, GL_TRANSFORM_FEEDBACK_BUFFER_BINDING,
                GL_TRANSFORM_FEEDBACK_BUFFER_START, GL_TRANSFORM_FEEDBACK_BUFFER_SIZE);
}

static void save_targets(struct host_state *state) {
    for (GLuint i = 0; i < DRAW_BUFFERS; i++) {
        state->draw_buffers[i].blends = state->IsEnabledi(GL_BLEND, i);
        state->draw_buffers[i].source_rgb = get_at(state, GL_BLEND_SRC_RGB, i);
        state->draw_buffers[i].source_alpha = get_at(state, GL_BLEND_SRC_ALPHA, i);
        state->draw_buffers[i].target_rgb = get_at(state, GL_BLEND_DST_RGB, i);
        state->draw_buffers[i].target_alpha = get_at(state, GL_BLEND_DST_ALPHA, i);
        state->draw_buffers[i].equation_rgb = get_at(state, GL_BLEND_EQUATION_RGB, i);
        state->draw_buffers[i].equation_alpha = get_at(state, GL_BLEND_EQUATION_ALPHA, i);
        state->GetBooleani_v(GL_COLOR_WRITEMASK, i, state->draw_buffers[i].mask);
    }
    for (GLuint i = 0; i < VIEWPORTS; i++) {
        state->viewports[i].scissors = state->IsEnabledi(GL_SCISSOR_TEST, i);
        state->GetFloati_v(GL_VIEWPORT, i, state->viewports[i].viewport);
        state->GetDoublei_v(GL_DEPTH_RANGE, i, state->viewports[i].depth);
    }
    state->draw_framebuffer = get(state, GL_DRAW_FRAMEBUFFER_BINDING);
    state->read_framebuffer = get(state, GL_READ_FRAMEBUFFER_BINDING);
}

static void save_others(struct host_state *state) {
    for (int i = 0; i < CAPABILITIES; i++)
        state->enabled[i] = state->IsEnabled(capabilities[i].name);
    for (int i = 0; i < STORAGE_ROWS; i++)
        state->stored[i] = get(state, storage[i].name);
    state->vertex_array = get(state, GL_VERTEX_ARRAY_BINDING);
    state->program = get(state, GL_CURRENT_PROGRAM);
    state->depth_mask = get(state, GL_DEPTH_WRITEMASK);
    state->depth_func = get(state, GL_DEPTH_FUNC);
    state->cull_face = get(state, GL_CULL_FACE_MODE);
    state->front_face = get(state, GL_FRONT_FACE);
    state->GetIntegerv(GL_POLYGON_MODE, state->polygon_mode);
    state->clip_origin = get(state, GL_CLIP_ORIGIN);
    state->clip_depth = get(state, GL_CLIP_DEPTH_MODE);
    state->provoking_vertex = get(state, GL_PROVOKING_VERTEX);
    state->GetFloatv(GL_POINT_SIZE, &state->point_size);
}

/* --- the defaults that passes count on -------------------------------------------------------- */

static void set_enabled(const struct host_state *state, GLenum name, bool on) {
    (on ? state->Enable : state->Disable)(name);
}

static void set_defaults(const struct host_state *state) {
    for (int i = 0; i < CAPABILITIES; i++)
        set_enabled(state, capabilities[i].name, capabilities[i].on);
    for (int i = 0; i < STORAGE_ROWS; i++)
        state->PixelStorei(storage[i].name, storage[i].standard);
    for (GLuint unit = 0; unit < UNITS; unit++)
        state->BindSampler(unit, 0);
    state->BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    state->BindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    state->DepthRange(0, 1);
    state->FrontFace(GL_CCW);
    state->PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    state->ProvokingVertex(GL_LAST_VERTEX_CONVENTION);
    state->PointSize(1);
}

void host_state_save(struct host_state *state) {
    save_others(state);
    save_textures(state);
    save_buffers(state);
    save_targets(state);
    set_defaults(state);
    while (state->GetError() != GL_NO_ERROR) /* what follows must be the renderer's own error */
        ;
}

/* --- putting back ----------------------------------------------------------------------------- */

static void restore_textures(const struct host_state *state) {
    for (GLuint unit = 0; unit < UNITS; unit++) {
        state->BindTextureUnit(unit, 0);
        for (int i = 0; i < TARGETS; i++)
            if (state->textures[unit][i])
                state->BindTextureUnit(unit, (GLuint)state->textures[unit][i]);
        state->BindSampler(unit, (GLuint)state->samplers[unit]);
    }
    state->ActiveTexture((GLenum)state->active_unit);
    for (GLuint i = 0; i < IMAGES; i++)
        state->BindImageTexture(i, (GLuint)state->images[i].texture, state->images[i].level,
                                state->images[i].layered != 0, state->images[i].layer,
                                (GLenum)state->images[i].access, (GLenum)state->images[i].format);
}

static void restore_ranges(const struct host_state *state, const struct range *ranges, GLuint count,
                           GLenum target) {
    for (GLuint i = 0; i < count; i++)
        if (ranges[i].size > 0)
            state->BindBufferRange(target, i, (GLuint)ranges[i].buffer, (GLintptr)ranges[i].start,
                                   (GLsizeiptr)ranges[i].size);
        else
            state->BindBufferBase(target, i, (GLuint)ranges[i].buffer);
}

/* Ranges first: they bind the buffer without a number, too. */
static void restore_buffers(const struct host_state *state) {
    restore_ranges(state, state->blocks, BLOCKS, GL_UNIFORM_BUFFER);
    restore_ranges(state, state->storages, STORAGES, GL_SHADER_STORAGE_BUFFER);
    state->BindTransformFeedback(GL_TRANSFORM_FEEDBACK, 0);
    restore_ranges(state, state->feedbacks, FEEDBACKS, GL_TRANSFORM_FEEDBACK_BUFFER);
    state->BindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, (GLuint)state->feedback);
    state->BindTransformFeedback(GL_TRANSFORM_FEEDBACK, (GLuint)state->feedback_object);
    state->BindBuffer(GL_UNIFORM_BUFFER, (GLuint)state->block);
    state->BindBuffer(GL_SHADER_STORAGE_BUFFER, (GLuint)state->storage);
    state->BindBuffer(GL_DISPATCH_INDIRECT_BUFFER, (GLuint)state->indirect);
    state->BindBuffer(GL_PIXEL_PACK_BUFFER, (GLuint)state->pack_buffer);
    state->BindBuffer(GL_PIXEL_UNPACK_BUFFER, (GLuint)state->unpack_buffer);
}

static void set_enabled_at(const struct host_state *state, GLenum name, GLuint i, bool on) {
    (on ? state->Enablei : state->Disablei)(name, i);
}

static void restore_targets(const struct host_state *state) {
    for (GLuint i = 0; i < DRAW_BUFFERS; i++) {
        set_enabled_at(state, GL_BLEND, i, state->draw_buffers[i].blends);
        state->BlendFuncSeparatei(i, (GLenum)state->draw_buffers[i].source_rgb,
                                  (GLenum)state->draw_buffers[i].target_rgb,
                                  (GLenum)state->draw_buffers[i].source_alpha,
                                  (GLenum)state->draw_buffers[i].target_alpha);
        state->BlendEquationSeparatei(i, (GLenum)state->draw_buffers[i].equation_rgb,
                                      (GLenum)state->draw_buffers[i].equation_alpha);
        const GLboolean *mask = state->draw_buffers[i].mask;
        state->ColorMaski(i, mask[0], mask[1], mask[2], mask[3]);
    }
    for (GLuint i = 0; i < VIEWPORTS; i++) {
        const GLfloat *viewport = state->viewports[i].viewport;
        set_enabled_at(state, GL_SCISSOR_TEST, i, state->viewports[i].scissors);
        state->ViewportIndexedf(i, viewport[0], viewport[1], viewport[2], viewport[3]);
        state->DepthRangeIndexed(i, state->viewports[i].depth[0], state->viewports[i].depth[1]);
    }
    state->BindFramebuffer(GL_DRAW_FRAMEBUFFER, (GLuint)state->draw_framebuffer);
    state->BindFramebuffer(GL_READ_FRAMEBUFFER, (GLuint)state->read_framebuffer);
}

static void restore_others(const struct host_state *state) {
    for (int i = 0; i < CAPABILITIES; i++)
        set_enabled(state, capabilities[i].name, state->enabled[i]);
    for (int i = 0; i < STORAGE_ROWS; i++)
        state->PixelStorei(storage[i].name, state->stored[i]);
    state->BindVertexArray((GLuint)state->vertex_array);
    state->UseProgram((GLuint)state->program);
    state->DepthMask(state->depth_mask != 0);
    state->DepthFunc((GLenum)state->depth_func);
    state->CullFace((GLenum)state->cull_face);
    state->FrontFace((GLenum)state->front_face);
    state->PolygonMode(GL_FRONT_AND_BACK, (GLenum)state->polygon_mode[0]);
    state->ClipControl((GLenum)state->clip_origin, (GLenum)state->clip_depth);
    state->ProvokingVertex((GLenum)state->provoking_vertex);
    state->PointSize(state->point_size);
}

void host_state_restore(const struct host_state *state) {
    restore_textures(state);
    restore_buffers(state);
    restore_targets(state);
    restore_others(state);
    while (state->GetError() != GL_NO_ERROR)
        ;
}
