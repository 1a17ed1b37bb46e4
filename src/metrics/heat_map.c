#include "metrics/heat_map.h"

#include "base/file/image_file.h"
#include "base/memory.h"
#include "metrics/colour.h"
#include "metrics/label.h"
#include "metrics/quantile.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum {
    SMALLEST_WIDTH = 256,  /* of the picture: room for the labels */
    WIDTH_PER_SCALE = 800, /* labels grow by one pixel per dot for each so many pixels */
    /* Below the map, in dots of the labels. */
    BAR_TOP = 4,
    BAR_HEIGHT = 8,
    BAR_MARGIN = 18, /* left and right: half a label */
    TICKS_TOP = BAR_TOP + BAR_HEIGHT + 3,
    TITLE_TOP = TICKS_TOP + LABEL_HEIGHT + 5,
    LEGEND_HEIGHT = TITLE_TOP + LABEL_HEIGHT + 4,
    TICK_COUNT = 5,
    FIT_VALUES = 65536, /* to sort those of a large picture takes longer than a frame */
};

static const float pi = 3.14159265f;

float heat_map_fit_top(const float *values, size_t count) {
    size_t used = count < FIT_VALUES ? count : FIT_VALUES;
    float *magnitudes = mem_alloc(used, sizeof *magnitudes), largest = 0;
    for (size_t i = 0; i < count; i++)
        largest = fmaxf(largest, fabsf(values[i]));
    for (size_t k = 0; k < used; k++) {
        double turns = (double)k * .618033988749895;
        size_t i = used == count ? k : (size_t)((turns - floor(turns)) * (double)count);
        magnitudes[k] = fabsf(values[i]);
    }
    float most = quantile(magnitudes, used, 0.99);
    free(magnitudes);
    float top = most > 0 ? most : largest;
    if (!(top > 0 && isfinite(top)))
        return 1;
    float power = powf(10, floorf(log10f(top))), leading = top / power;
    return power * (leading <= 1 ? 1 : leading <= 2 ? 2 : leading <= 5 ? 5 : 10);
}

static void lch_to_rgb8(float lightness, float chroma, float hue, unsigned char rgb8[3]) {
    float rgb[3], angle = hue * pi / 180;
    lab_to_rgb((const float[]){lightness, chroma * cosf(angle), chroma * sinf(angle)}, rgb);
    for (int c = 0; c < 3; c++)
        rgb8[c] = (unsigned char)lrintf(255 * srgb_encode(rgb[c]));
}

/* Black, violet, crimson, orange, pale yellow. */
static void colour_positive(float t, unsigned char rgb8[3]) {
    lch_to_rgb8(97 * t, 60 * sinf(pi * t) + 20 * t, 285 + 175 * t, rgb8);
}

/* Blue below 0, white, red above. */
static void colour_signed(float t, unsigned char rgb8[3]) {
    float magnitude = fabsf(t);
    lch_to_rgb8(97 - 57 * magnitude, 60 * magnitude, t < 0 ? 288 : 35, rgb8);
}

void heat_map_color(const struct heat_map *map, float value, unsigned char rgb8[3]) {
    float t = value / map->top;
    if (map->is_signed)
        colour_signed(fmaxf(-1, fminf(t, 1)), rgb8);
    else
        colour_positive(clamp_unit(t), rgb8);
}

static void set_pixel(struct bitmap *picture, int x, int y, const struct heat_map *map,
                      float value) {
    heat_map_color(map, value,
                   picture->rgba + ((size_t)y * (size_t)picture->width + (size_t)x) * 4);
}

static void draw_values(const struct heat_map *map, struct bitmap *picture, int zoom) {
    for (int y = 0; y < map->height * zoom; y++)
        for (int x = 0; x < map->width * zoom; x++) {
            size_t at = (size_t)(y / zoom) * (size_t)map->width + (size_t)(x / zoom);
            set_pixel(picture, x, y, map, map->values[at]);
        }
}

static float value_along_bar(const struct heat_map *map, float t) {
    return map->is_signed ? map->top * (2 * t - 1) : map->top * t;
}

static void draw_legend(const struct heat_map *map, struct bitmap *picture, int top, int dot) {
    int left = BAR_MARGIN * dot, length = picture->width - 2 * left;
    for (int y = 0; y < BAR_HEIGHT * dot; y++)
        for (int x = 0; x < length; x++)
            set_pixel(picture, left + x, top + BAR_TOP * dot + y, map,
                      value_along_bar(map, ((float)x + 0.5f) / (float)length));
    for (int i = 0; i < TICK_COUNT; i++) {
        char text[16];
        float t = (float)i / (TICK_COUNT - 1);
        snprintf(text, sizeof text, "%.3g", (double)value_along_bar(map, t));
        int centre = left + (int)lrintf(t * (float)length);
        label_draw(picture, centre - label_width(text, dot) / 2, top + TICKS_TOP * dot, dot, text);
    }
    label_draw(picture, left, top + TITLE_TOP * dot, dot, map->title);
}

static void init_picture(struct bitmap *picture, int width, int height) {
    size_t pixel_count = (size_t)width * (size_t)height;
    *picture = (struct bitmap){width, height, mem_alloc(pixel_count, 4)};
    for (size_t i = 0; i < pixel_count; i++)
        picture->rgba[4 * i + 3] = 255;
}

void heat_map_draw_values(const struct heat_map *map, struct bitmap *picture) {
    init_picture(picture, map->width, map->height);
    draw_values(map, picture, 1);
}

void heat_map_add_scale(const struct heat_map *map, struct bitmap *picture) {
    struct bitmap above = *picture;
    int width = above.width > SMALLEST_WIDTH ? above.width : SMALLEST_WIDTH;
    int dot = 1 + width / WIDTH_PER_SCALE;
    init_picture(picture, width, above.height + LEGEND_HEIGHT * dot);
    for (int y = 0; y < above.height; y++)
        memcpy(picture->rgba + 4 * (size_t)y * (size_t)width,
               above.rgba + 4 * (size_t)y * (size_t)above.width, 4 * (size_t)above.width);
    draw_legend(map, picture, above.height, dot);
    bitmap_free(&above);
}

void heat_map_draw(const struct heat_map *map, struct bitmap *picture) {
    int longest = map->width > map->height ? map->width : map->height;
    int zoom = longest < SMALLEST_WIDTH ? SMALLEST_WIDTH / longest : 1;
    init_picture(picture, map->width * zoom, map->height * zoom);
    draw_values(map, picture, zoom);
    heat_map_add_scale(map, picture);
}

static bool write_values(const struct heat_map *map, const char *path) {
    struct image picture;
    image_init(&picture, map->width, map->height, "Y");
    memcpy(picture.pixels, map->values,
           (size_t)map->width * (size_t)map->height * sizeof *map->values);
    bool ok = image_write(&picture, path);
    image_free(&picture);
    return ok;
}

bool heat_map_write(const struct heat_map *map, const char *path) {
    bool is_float;
    struct bitmap picture;
    if (!image_format_is_float(path, &is_float))
        return false;
    if (is_float)
        return write_values(map, path);
    heat_map_draw(map, &picture);
    bool ok = bitmap_write(&picture, path);
    bitmap_free(&picture);
    return ok;
}
