#include "gl/screen.h"

#include "gl/framebuffer.h"
#include "gl/program.h"
#include "gl/screen_glsl.h"
#include "gl/screen_rows.h"
#include "shared/bindings.h"

#include <assert.h>

/* The pass that is dispatched; program 0: the pass draws. A context is one thread's at a time, and
 * no pass outlives that. */
static _Thread_local struct {
    GLuint program;
    bool tiled;
    const struct pixel_mask *marked,
        *masked; /* that it marks, and whose pixels it runs at; or NULL */
    struct screen_rectangle area;
} pass;

bool screen_dispatches(void) {
    return pass.program;
}

void screen_viewport(int x, int y, int width, int height) {
    pass.area = (struct screen_rectangle){x, y, width, height};
}

/* --- what the dispatch writes, and where ------------------------------------------------------ */

/* Images have all layers of their texture. */
static void bind_targets(GLuint framebuffer, const struct screen_desc *desc) {
    const struct framebuffer_targets *targets = framebuffer_targets(framebuffer);
    for (GLuint i = 0; i < FRAMEBUFFER_COLORS_MAX; i++) {
        const struct framebuffer_target *color = &targets->colors[i];
        if (!color->texture)
            continue;
        assert((color->kind == GL_TEXTURE_2D_ARRAY) == desc->layers);
        assert(!desc->blended || color->format == GL_RGBA32F);
        gl.BindImageTexture(IMAGE_SCREEN_TARGETS + i, color->texture, 0, GL_TRUE, 0,
                            desc->blended ? GL_READ_WRITE : GL_WRITE_ONLY, color->format);
    }
}

static void bind_mask(const struct pass_state *state, const struct screen_desc *desc) {
    pass.marked = desc->marks ? state->mask : NULL;
    pass.masked = desc->masked ? state->mask : NULL;
    assert(state->depth == (desc->marks    ? PASS_DEPTH_LESS
                            : desc->masked ? PASS_DEPTH_EQUAL
                                           : PASS_DEPTH_OFF));
    if (desc->marks || desc->masked)
        gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, STORAGE_SCREEN_QUEUE, state->mask->queue.id);
}

void screen_begin(const struct pass_state *state) {
    const struct screen_desc *desc = program_dispatched(state->program);
    assert(screen_rows_empty());
    pass.program = desc ? state->program : 0;
    pass.tiled = desc && desc->tiled;
    if (!desc)
        return;
    assert(!state->window);
    if (!desc->marks)
        bind_targets(state->framebuffer, desc);
    bind_mask(state, desc);
    if (desc->blended)
        gl.ProgramUniform1i(state->program, LOCATION_SCREEN_ADDS, state->blend == PASS_BLEND_ADD);
    assert(state->blend == PASS_BLEND_OFF || (state->blend == PASS_BLEND_ADD && desc->blended));
    screen_viewport(state->x, state->y, state->width, state->height);
}

/* --- the dispatch ----------------------------------------------------------------------------- */

/* All ways that targets are read and written by what comes after: fetched, stored, drawn to or
 * cleared, copied. */
static const GLbitfield later = GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT |
                                GL_FRAMEBUFFER_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT;

/* And all ways that a queue is: by the dispatch over it, by its shader, and cleared for the next */
static const GLbitfield of_queue =
    GL_COMMAND_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT;

static int groups(int pixels) {
    return (pixels + SCREEN_GROUP - 1) / SCREEN_GROUP;
}

/* Stores wait for what is read and drawn before by the barrier of images. */
static void dispatch(int width, int height, int count) {
    gl.MemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    pass_dispatch(groups(width), groups(height), count);
    gl.MemoryBarrier(pass.marked ? later | of_queue : later);
}

/* At the marked pixels. */
static void dispatch_queue(void) {
    gl.BindBuffer(GL_DISPATCH_INDIRECT_BUFFER, pass.masked->queue.id);
    gl.MemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    gl.DispatchComputeIndirect(0);
    gl.MemoryBarrier(later);
}

static void dispatch_rows(int width, int height, int first, int count, int stride) {
    gl.ProgramUniform2i(pass.program, LOCATION_SCREEN_ROW, first, stride);
    dispatch(width, height, count);
}

void screen_end(void) {
    screen_rows_flush(dispatch_rows);
}

void screen_draw_part(int part) {
    assert(pass.tiled);
    if (screen_rows_full())
        screen_end();
    screen_rows_add(&pass.area, part);
}

void screen_draw_layers(int layers) {
    const struct screen_rectangle *area = &pass.area;
    if (pass.tiled) {
        screen_draw_part(0);
        return;
    }
    if (pass.masked) {
        assert(layers == 1);
        dispatch_queue();
        return;
    }
    gl.ProgramUniform4i(pass.program, LOCATION_SCREEN_AREA, area->x, area->y, area->width,
                        area->height);
    dispatch(area->width, area->height, layers);
}

bool screen_takes(GLint location, const void *values, size_t size, int count) {
    if (pass.tiled)
        screen_rows_set(location, values, size, count);
    return pass.tiled;
}
