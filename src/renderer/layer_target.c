#include "renderer/layer_target.h"

#include "base/memory.h"
#include "gl/framebuffer.h"

#include <stdlib.h>
#include <string.h>

bool layer_target_init(struct layer_target *target, int width, int height) {
    *target = (struct layer_target){0};
    if (texture_init(&target->texture, &(struct texture_desc){.label = "layer",
                                                              .format = GL_RGBA32F,
                                                              .width = width,
                                                              .height = height}) &&
        framebuffer_init(&target->framebuffer, &(struct framebuffer_desc){
                                                   .label = "layer", .colors = {&target->texture}}))
        return true;
    layer_target_free(target);
    return false;
}

void layer_target_free(struct layer_target *target) {
    framebuffer_free(&target->framebuffer);
    texture_free(&target->texture);
}

void layer_target_read(const struct layer_target *target, int first, int count, struct image *image,
                       int channel) {
    size_t row = (size_t)image->width * 4, bytes = row * (size_t)image->height * sizeof(float);
    int bottom = target->texture.desc.height - target->y - image->height;
    float *rgba = mem_alloc(bytes, 1);
    gl.GetTextureSubImage(target->texture.id, 0, target->x, bottom, 0, image->width, image->height,
                          1, GL_RGBA, GL_FLOAT, (GLsizei)bytes, rgba);
    for (int y = 0; y < image->height; y++) {
        const float *from = rgba + (size_t)(image->height - 1 - y) * row + first;
        for (int x = 0; x < image->width; x++)
            memcpy(image_at(image, x, y) + channel, from + (size_t)x * 4,
                   (size_t)count * sizeof *rgba);
    }
    free(rgba);
}
