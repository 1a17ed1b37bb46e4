#include "gl/framebuffer.h"

#include "base/error.h"
#include "base/memory.h"

#include <assert.h>
#include <string.h>

/* --- what framebuffers attach ----------------------------------------------------------------- */

/* By the framebuffer's number: drivers count from 1, and take numbers again. */
struct framebuffer_list {
    struct framebuffer_targets *items;
    GLuint count;
};

struct framebuffer_list *framebuffer_list_create(void) {
    return mem_alloc(1, sizeof(struct framebuffer_list));
}

void framebuffer_list_free(struct framebuffer_list *list) {
    if (list)
        free(list->items);
    free(list);
}

const struct framebuffer_targets *framebuffer_targets(GLuint framebuffer) {
    assert(framebuffer && framebuffer < gl.framebuffers->count);
    return &gl.framebuffers->items[framebuffer];
}

static void note(GLuint framebuffer, const struct framebuffer_desc *desc) {
    struct framebuffer_list *list = gl.framebuffers;
    if (framebuffer >= list->count) {
        list->items = mem_resize(list->items, framebuffer + 1, sizeof *list->items);
        memset(&list->items[list->count], 0, (framebuffer + 1 - list->count) * sizeof *list->items);
        list->count = framebuffer + 1;
    }
    struct framebuffer_targets targets = {.depth = desc->depth ? desc->depth->id : 0};
    for (int i = 0; i < FRAMEBUFFER_COLORS_MAX; i++)
        if (desc->colors[i])
            targets.colors[i] = (struct framebuffer_target){
                desc->colors[i]->id, desc->colors[i]->desc.target, desc->colors[i]->desc.format};
    list->items[framebuffer] = targets;
}

/* --- framebuffers ----------------------------------------------------------------------------- */

bool framebuffer_init(GLuint *framebuffer, const struct framebuffer_desc *desc) {
    GLenum buffers[FRAMEBUFFER_COLORS_MAX];
    int count = 0;
    gl.CreateFramebuffers(1, framebuffer);
    for (int i = 0; i < FRAMEBUFFER_COLORS_MAX; i++) {
        buffers[i] = GL_NONE;
        if (!desc->colors[i])
            continue;
        buffers[i] = GL_COLOR_ATTACHMENT0 + (GLenum)i;
        gl.NamedFramebufferTexture(*framebuffer, buffers[i], desc->colors[i]->id, 0);
        count = i + 1;
    }
    if (desc->depth)
        gl.NamedFramebufferTexture(*framebuffer, GL_DEPTH_ATTACHMENT, desc->depth->id, 0);
    gl.NamedFramebufferDrawBuffers(*framebuffer, count, buffers);
    gl.ObjectLabel(GL_FRAMEBUFFER, *framebuffer, -1, desc->label);
    note(*framebuffer, desc);
    GLenum status = gl.CheckNamedFramebufferStatus(*framebuffer, GL_DRAW_FRAMEBUFFER);
    if (status == GL_FRAMEBUFFER_COMPLETE)
        return true;
    framebuffer_free(framebuffer);
    return error_set("framebuffer '%s' is refused by the driver (0x%x)", desc->label, status);
}

bool framebuffer_init_target(struct texture *texture, GLuint *framebuffer,
                             const struct texture_desc *desc) {
    return texture_init(texture, desc) &&
           framebuffer_init(framebuffer,
                            &(struct framebuffer_desc){.label = desc->label, .colors = {texture}});
}

void framebuffer_free(GLuint *framebuffer) {
    if (*framebuffer)
        gl.DeleteFramebuffers(1, framebuffer);
    *framebuffer = 0;
}

void framebuffer_clear_color(GLuint framebuffer, int target, const float rgba[4]) {
    gl.ClearNamedFramebufferfv(framebuffer, GL_COLOR, target, rgba);
}

void framebuffer_clear_integers(GLuint framebuffer, int target, const GLuint rgba[4]) {
    gl.ClearNamedFramebufferuiv(framebuffer, GL_COLOR, target, rgba);
}

void framebuffer_clear_depth(GLuint framebuffer, float depth) {
    gl.DepthMask(GL_TRUE);
    gl.ClearNamedFramebufferfv(framebuffer, GL_DEPTH, 0, &depth);
}
