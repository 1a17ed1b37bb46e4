#include "gl/pass.h"

#include <assert.h>

enum { CLIP_DISTANCES_MAX = 4 };

static void enable(GLenum capability, bool on) {
    if (on)
        gl.Enable(capability);
    else
        gl.Disable(capability);
}

void pass_set_state(const struct pass_state *state) {
    assert(state->clip_distances <= CLIP_DISTANCES_MAX);
    gl.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    gl.UseProgram(state->program);
    gl.BindFramebuffer(GL_FRAMEBUFFER,
                       state->framebuffer ? state->framebuffer : gl.empty_framebuffer);
    gl.BindVertexArray(state->vertex_array ? state->vertex_array : gl.empty_vertex_array);
    gl.Viewport(state->x, state->y, state->width, state->height);
    enable(GL_DEPTH_TEST, state->depth != PASS_DEPTH_OFF);
    gl.DepthMask(state->depth != PASS_DEPTH_OFF);
    gl.DepthFunc(state->depth == PASS_DEPTH_GREATER ? GL_GREATER : GL_LESS);
    enable(GL_BLEND, state->blend != PASS_BLEND_OFF);
    gl.BlendFunc(GL_ONE, state->blend == PASS_BLEND_OVER ? GL_ONE_MINUS_SRC_ALPHA : GL_ONE);
    gl.BlendEquation(state->blend == PASS_BLEND_MAX ? GL_MAX : GL_FUNC_ADD);
    enable(GL_CULL_FACE, state->cull_back);
    gl.Disable(GL_SCISSOR_TEST);
    gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    for (int i = 0; i < CLIP_DISTANCES_MAX; i++)
        enable(GL_CLIP_DISTANCE0 + (GLenum)i, i < state->clip_distances);
}

void pass_begin(struct timers *timers, const struct pass_state *state) {
    timer_begin(timers, state->name);
    pass_set_state(state);
}

void pass_end(struct timers *timers) {
    timer_end(timers);
}

void pass_draw_fullscreen(int instances) {
    gl.DrawArraysInstanced(GL_TRIANGLES, 0, 3, instances);
}

void pass_feedback(GLuint buffer, int first, int count) {
    /* Only for this draw: discarding would swallow later clears too. */
    gl.Enable(GL_RASTERIZER_DISCARD);
    gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
    gl.BeginTransformFeedback(GL_POINTS);
    gl.DrawArrays(GL_POINTS, first, count);
    gl.EndTransformFeedback();
    gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
    gl.Disable(GL_RASTERIZER_DISCARD);
}
