#include "lab/export/textures.h"

#include "base/error.h"
#include "base/file/image_file.h"
#include "base/memory.h"

#include <string.h>

static bool write_image(const struct export_target *target, struct image *image, const char *name) {
    char *path = export_path(target, name);
    bool ok = image_write(image, path);
    image_free(image);
    free(path);
    return ok;
}

bool export_color_texture(const struct export_target *target, int texture, vec3s factor,
                          const char *name) {
    const struct scene_texture *from = &target->stage->scene.textures[texture];
    const struct bitmap *bitmap = &from->bitmap;
    struct image image;
    image_init(&image, bitmap->width, bitmap->height, "R G B");
    for (int i = 0; i < bitmap->width * bitmap->height; i++)
        for (int c = 0; c < 3; c++) {
            unsigned char byte = bitmap->rgba[4 * (size_t)i + (size_t)c];
            float value = from->linear ? (float)byte / 255 : target->srgb_to_linear[byte];
            image.pixels[3 * (size_t)i + (size_t)c] = factor.raw[c] * value;
        }
    return write_image(target, &image, name);
}

bool export_mask(const struct export_target *target, const struct material *material,
                 const char *name) {
    const struct bitmap *from = &target->stage->scene.textures[material->base_color_texture].bitmap;
    size_t count = (size_t)from->width * (size_t)from->height;
    struct bitmap mask = {from->width, from->height, mem_alloc(4 * count, 1)};
    for (size_t i = 0; i < count; i++) {
        float alpha = material->base_color[3] * (float)from->rgba[4 * i + 3] / 255;
        memset(&mask.rgba[4 * i], material_is_hole(material, alpha) ? 0 : 255, 4);
    }
    char *path = export_path(target, name);
    bool ok = bitmap_write(&mask, path);
    bitmap_free(&mask);
    free(path);
    return ok;
}

/* --- environment ------------------------------------------------------------------------------ */

static bool write_panorama(const struct export_target *target, const char *name, int repeats) {
    const struct environment *from = target->stage->emitters.sky;
    struct image image;
    if (!image_fits(repeats * from->width, repeats * from->height, 3))
        return error_prefix("%s", name);
    image_init(&image, repeats * from->width, repeats * from->height, "R G B");
    for (int y = 0; y < image.height; y++)
        for (int x = 0; x < image.width; x++) {
            size_t texel = (size_t)(y / repeats) * (size_t)from->width + (size_t)(x / repeats);
            memcpy(image_at(&image, x, y), from->texels[texel], sizeof *from->texels);
        }
    return write_image(target, &image, name);
}

bool export_panorama(const struct export_target *target, const char *name) {
    return write_panorama(target, name, 1);
}

int export_panorama_repeats(const struct environment *environment) {
    const int enough = 2048;
    return environment->width < enough ? (enough + environment->width - 1) / environment->width : 1;
}

bool export_repeated_panorama(const struct export_target *target, const char *name) {
    return write_panorama(target, name, export_panorama_repeats(target->stage->emitters.sky));
}
