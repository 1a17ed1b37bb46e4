#include "gl/pass.h"

#include "gl/screen.h"

#include <assert.h>

enum { CLIP_DISTANCES_MAX = 4 };

static void enable(GLenum capability, bool on) {
    if (on)
        gl.Enable(capability);
    else
        gl.Disable(capability);
}

static void set_empty_size(GLuint framebuffer, int width, int height) {
    if (width && height) {
        gl.NamedFramebufferParameteri(framebuffer, GL_FRAMEBUFFER_DEFAULT_WIDTH, width);
        gl.NamedFramebufferParameteri(framebuffer, GL_FRAMEBUFFER_DEFAULT_HEIGHT, height);
    }
}

static void bind_target(const struct pass_state *state) {
    GLuint framebuffer = state->window ? 0 : state->framebuffer;
    if (!state->framebuffer && !state->window) {
        framebuffer = gl.empty_framebuffer;
        set_empty_size(framebuffer, state->width, state->height);
    }
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    pass_viewport(state->x, state->y, state->width, state->height);
    gl.Disable(GL_SCISSOR_TEST);
}

static const GLenum depth_functions[] = {
    [PASS_DEPTH_OFF] = GL_ALWAYS,
    [PASS_DEPTH_LESS] = GL_LESS,
    [PASS_DEPTH_GREATER] = GL_GEQUAL,
    [PASS_DEPTH_EQUAL] = GL_EQUAL,
};

static void set_fragments(const struct pass_state *state) {
    enable(GL_DEPTH_TEST, state->depth != PASS_DEPTH_OFF);
    gl.DepthMask(state->depth == PASS_DEPTH_LESS || state->depth == PASS_DEPTH_GREATER);
    gl.DepthFunc(depth_functions[state->depth]);
    enable(GL_BLEND, state->blend != PASS_BLEND_OFF);
    gl.BlendFunc(GL_ONE, state->blend == PASS_BLEND_OVER ? GL_ONE_MINUS_SRC_ALPHA : GL_ONE);
    gl.BlendEquation(state->blend == PASS_BLEND_MAX ? GL_MAX : GL_FUNC_ADD);
}

void pass_set_cull(enum pass_cull cull) {
    enable(GL_CULL_FACE, cull != PASS_CULL_NONE);
    gl.CullFace(cull == PASS_CULL_FRONT ? GL_FRONT : GL_BACK);
}

static void set_primitives(const struct pass_state *state) {
    assert(state->clip_distances <= CLIP_DISTANCES_MAX);
    gl.BindVertexArray(state->vertex_array ? state->vertex_array : gl.empty_vertex_array);
    gl.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    pass_set_cull(state->cull);
    enable(GL_PROGRAM_POINT_SIZE, state->point_size);
    for (int i = 0; i < CLIP_DISTANCES_MAX; i++)
        enable(GL_CLIP_DISTANCE0 + (GLenum)i, i < state->clip_distances);
}

static void bind_range(GLenum target, const struct pass_block *block) {
    size_t size = block->size ? block->size : block->buffer->size - block->offset;
    gl.BindBufferRange(target, block->block, block->buffer->id, (GLintptr)block->offset,
                       (GLsizeiptr)size);
}

/* All layers. */
static void bind_image(const struct pass_image *image) {
    gl.BindImageTexture(image->image, image->texture->id, image->level, GL_TRUE, 0, image->access,
                        image->texture->desc.format);
}

static void bind_all(const struct pass_state *state) {
    for (int i = 0; i < PASS_TEXTURES_MAX && state->textures[i].texture; i++)
        pass_bind_texture(state->textures[i].unit, state->textures[i].texture);
    for (int i = 0; i < PASS_BLOCKS_MAX && state->blocks[i].buffer; i++)
        pass_bind_block(&state->blocks[i]);
    for (int i = 0; i < PASS_STORAGES_MAX && state->storages[i].buffer; i++)
        bind_range(GL_SHADER_STORAGE_BUFFER, &state->storages[i]);
    for (int i = 0; i < PASS_IMAGES_MAX && state->images[i].texture; i++)
        bind_image(&state->images[i]);
}

/* Lets what is queued read buffers and images before a pass writes them: llvmpipe from Mesa 25 on
 * reads uniform blocks only when it draws what is queued. */
static void wait_for_reads(void) {
    gl.MemoryBarrier(GL_UNIFORM_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT |
                     GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TRANSFORM_FEEDBACK_BARRIER_BIT);
}

static _Thread_local GLuint current_program;

void pass_set_state(const struct pass_state *state) {
    gl.UseProgram(state->program);
    current_program = state->program;
    screen_begin(state);
    if (!screen_dispatches()) {
        bind_target(state);
        set_fragments(state);
        set_primitives(state);
    }
    bind_all(state);
    if (state->storages[0].buffer || state->images[0].texture)
        wait_for_reads();
    if (state->barriers)
        gl.MemoryBarrier(state->barriers);
}

void pass_begin(struct timers *timers, const struct pass_state *state) {
    timer_begin(timers, state->name);
    pass_set_state(state);
}

void pass_end(struct timers *timers) {
    screen_end();
    timer_end(timers);
}

void pass_add_texture(struct pass_state *state, GLuint unit, GLuint texture) {
    int i = 0;
    while (i < PASS_TEXTURES_MAX && state->textures[i].texture)
        i++;
    assert(i < PASS_TEXTURES_MAX);
    state->textures[i] = (struct pass_texture){unit, texture};
}

void pass_add_block(struct pass_state *state, GLuint block, const struct buffer *buffer) {
    int i = 0;
    while (i < PASS_BLOCKS_MAX && state->blocks[i].buffer)
        i++;
    assert(i < PASS_BLOCKS_MAX);
    state->blocks[i] = (struct pass_block){.block = block, .buffer = buffer};
}

/* --- within a pass ---------------------------------------------------------------------------- */

void pass_bind_texture(GLuint unit, GLuint texture) {
    gl.BindTextureUnit(unit, texture);
}

/* Drivers ask for offsets that are multiples of 256 at most. */
void pass_bind_block(const struct pass_block *block) {
    assert(block->offset % 256 == 0);
    bind_range(GL_UNIFORM_BUFFER, block);
}

void pass_viewport(int x, int y, int width, int height) {
    if (screen_dispatches())
        screen_viewport(x, y, width, height);
    else
        gl.Viewport(x, y, width, height);
}

void pass_set_int(GLint location, int value) {
    if (!screen_takes(location, &value, sizeof value, 1))
        gl.ProgramUniform1i(current_program, location, value);
}

void pass_set_ints(GLint location, int x, int y, int z, int w) {
    const int values[4] = {x, y, z, w};
    if (!screen_takes(location, values, sizeof values, 1))
        gl.ProgramUniform4i(current_program, location, x, y, z, w);
}

void pass_set_float(GLint location, float value) {
    if (!screen_takes(location, &value, sizeof value, 1))
        gl.ProgramUniform1f(current_program, location, value);
}

void pass_set_floats(GLint location, float x, float y, float z, float w) {
    const float values[4] = {x, y, z, w};
    if (!screen_takes(location, values, sizeof values, 1))
        gl.ProgramUniform4f(current_program, location, x, y, z, w);
}

void pass_set_pairs(GLint location, int count, const float *pairs) {
    if (!screen_takes(location, pairs, 2 * sizeof *pairs, count))
        gl.ProgramUniform2fv(current_program, location, count, pairs);
}

void pass_draw_fullscreen(int instances) {
    if (screen_dispatches())
        screen_draw_layers(instances);
    else
        pass_draw(GL_TRIANGLES, 3, instances);
}

void pass_draw_part(int part, int vertices) {
    if (screen_dispatches())
        screen_draw_part(part);
    else
        pass_draw(GL_TRIANGLES, vertices, 1);
}

void pass_draw(GLenum primitive, int count, int instances) {
    gl.DrawArraysInstanced(primitive, 0, count, instances);
}

void pass_feedback(GLuint buffer, int first, int count) {
    wait_for_reads();
    /* Only for this draw: discarding would swallow later clears too. */
    gl.Enable(GL_RASTERIZER_DISCARD);
    gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
    gl.BeginTransformFeedback(GL_POINTS);
    gl.DrawArrays(GL_POINTS, first, count);
    gl.EndTransformFeedback();
    gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
    gl.Disable(GL_RASTERIZER_DISCARD);
}

void pass_dispatch(int x, int y, int z) {
    gl.DispatchCompute((GLuint)x, (GLuint)y, (GLuint)z);
}
