#include "gl/pixel_mask.h"

#include "gl/framebuffer.h"
#include "gl/screen.h"

/* What the queue begins with: workgroups of the indirect dispatch, then how many pixels
 * there are. */
static const GLuint none[] = {0, 1, 1, 0};

static bool init_depth(struct pixel_mask *mask, const char *label, int width, int height) {
    return texture_init(&mask->depth, &(struct texture_desc){.label = label,
                                                             .format = GL_DEPTH_COMPONENT16,
                                                             .width = width,
                                                             .height = height}) &&
           framebuffer_init(&mask->framebuffer,
                            &(struct framebuffer_desc){.label = label, .depth = &mask->depth});
}

static bool init_queue(struct pixel_mask *mask, const char *label, int width, int height) {
    size_t pixels = (size_t)width * (size_t)height;
    return buffer_init(&mask->queue, label, sizeof none + pixels * sizeof(GLuint), NULL);
}

bool pixel_mask_init(struct pixel_mask *mask, const char *label, int width, int height) {
    bool dispatched = screen_way() == SCREEN_COMPUTE;
    *mask = (struct pixel_mask){0};
    if ((dispatched ? init_queue : init_depth)(mask, label, width, height))
        return true;
    pixel_mask_free(mask);
    return false;
}

void pixel_mask_free(struct pixel_mask *mask) {
    framebuffer_free(&mask->framebuffer);
    texture_free(&mask->depth);
    buffer_free(&mask->queue);
    *mask = (struct pixel_mask){0};
}

void pixel_mask_clear(const struct pixel_mask *mask) {
    if (mask->framebuffer)
        framebuffer_clear_depth(mask->framebuffer, 1);
    else
        buffer_write(&mask->queue, 0, sizeof none, none);
}

const struct texture *pixel_mask_depth(const struct pixel_mask *mask) {
    return mask->framebuffer ? &mask->depth : NULL;
}
