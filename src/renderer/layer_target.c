#include "renderer/layer_target.h"

#include "base/memory.h"
#include "gl/framebuffer.h"

#include <string.h>

bool layer_target_init(struct layer_target *target, int width, int height) {
    *target = (struct layer_target){0};
    if (framebuffer_init_target(
            &target->texture, &target->framebuffer,
            &(struct texture_desc){
                .label = "layer", .format = GL_RGBA32F, .width = width, .height = height}))
        return true;
    layer_target_free(target);
    return false;
}

void layer_target_free(struct layer_target *target) {
    framebuffer_free(&target->framebuffer);
    texture_free(&target->texture);
}

/* Rows that are read at once, 1 MiB or one row: GL counts no more than 2 GiB. */
static int rows_of_band(int width, int height) {
    enum { BAND_PIXELS = 1 << 16 };
    int rows = width < BAND_PIXELS ? BAND_PIXELS / width : 1;
    return rows < height ? rows : height;
}

void layer_target_read(const struct layer_target *target, int first, int count, struct image *image,
                       int channel) {
    int rows = rows_of_band(image->width, image->height);
    size_t row = (size_t)image->width * 4, bytes = row * (size_t)rows * sizeof(float);
    int bottom = target->texture.desc.height - target->y - image->height;
    float *rgba = mem_alloc(bytes, 1);
    for (int from = 0; from < image->height; from += rows) {
        int read = image->height - from < rows ? image->height - from : rows;
        gl.GetTextureSubImage(target->texture.id, 0, target->x, bottom + from, 0, image->width,
                              read, 1, GL_RGBA, GL_FLOAT, (GLsizei)bytes, rgba);
        for (int y = 0; y < read; y++)
            for (int x = 0; x < image->width; x++)
                memcpy(image_at(image, x, image->height - 1 - from - y) + channel,
                       rgba + (size_t)y * row + (size_t)x * 4 + first,
                       (size_t)count * sizeof *rgba);
    }
    free(rgba);
}
