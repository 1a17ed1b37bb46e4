#include "gl/screen.h"

#include "gl/framebuffer.h"
#include "gl/program.h"
#include "gl/screen_glsl.h"

#include <assert.h>

/* The pass that is dispatched; program 0: the pass draws. A context is one thread's at a time, and no pass outlives
 * that. */
static _Thread_local struct {
    GLuint program;
    int x, y, width, height;
} pass;

bool screen_dispatches(void) {
    return pass.program;
}

void screen_viewport(int x, int y, int width, int height) {
    pass.x = x;
    pass.y = y;
    pass.width = width;
    pass.height = height;
}

/* --- what the dispatch writes, and where ------------------------------------------------------ */

/* Images have all layers of their texture. */
static void bind_targets(const struct framebuffer_targets *targets,
                         const struct screen_desc *desc) {
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

static void set_mask(const struct pass_state *state, const struct framebuffer_targets *targets) {
    assert(state->depth == PASS_DEPTH_EQUAL || state->depth == PASS_DEPTH_UNEQUAL);
    pass_bind_texture(SCREEN_MASK_UNIT, targets->depth);
    gl.ProgramUniform1i(state->program, LOCATION_SCREEN_WHERE_MARKED,
                        state->depth == PASS_DEPTH_EQUAL);
}

void screen_begin(const struct pass_state *state) {
    const struct screen_desc *desc = program_dispatched(state->program);
    pass.program = desc ? state->program : 0;
    if (!desc)
        return;
    const struct framebuffer_targets *targets = framebuffer_targets(state->framebuffer);
    assert(!state->window && !state->kept_colors);
    bind_targets(targets, desc);
    if (desc->masked)
        set_mask(state, targets);
    assert(desc->masked || state->depth == PASS_DEPTH_OFF);
    if (desc->blended)
        gl.ProgramUniform1i(state->program, LOCATION_SCREEN_ADDS, state->blend == PASS_BLEND_ADD);
    assert(state->blend == PASS_BLEND_OFF || (state->blend == PASS_BLEND_ADD && desc->blended));
    screen_viewport(state->x, state->y, state->width, state->height);
}

/* --- the dispatch ------------------------------------------------------------------------------ */

/* All ways that targets are read and written by what comes after: fetched, stored, drawn to or cleared, copied. */
static const GLbitfield later = GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT |
                                GL_FRAMEBUFFER_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT;

static int groups(int pixels) {
    return (pixels + SCREEN_GROUP - 1) / SCREEN_GROUP;
}

/* Stores wait for what is read and drawn before by the barrier of images. */
void screen_dispatch(int layers) {
    gl.ProgramUniform4i(pass.program, LOCATION_SCREEN_AREA, pass.x, pass.y, pass.width,
                        pass.height);
    gl.MemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    pass_dispatch(groups(pass.width), groups(pass.height), layers);
    gl.MemoryBarrier(later);
}
