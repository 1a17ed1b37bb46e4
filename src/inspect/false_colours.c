#include "inspect/false_colours.h"

#include "base/memory.h"
#include "metrics/colour.h"
#include "shared/composite.h"

#include <stdlib.h>

const char *const light_unit_names[] = {"lux", "lux, 683 lm/W", "lux, 179 lm/W", "W/m2"};

bool false_colours_init(struct heat_map *map, struct renderer *renderer, enum output_kind kind,
                        enum light_unit unit, float top) {
    static const char *const titles[][2] = {{"lux", "cd/m2"}, {"W/m2", "W/(sr m2)"}};
    static const float lumens[] = {1, 683, 179, 1}, pi = 3.14159265F;
    const unsigned seen = 1 << LAYER_BEAUTY;
    const unsigned received = 1 << LAYER_DIRECT | 1 << LAYER_INDIRECT | 1 << LAYER_CAUSTIC;
    bool is_seen = kind == OUTPUT_LUMINANCE;
    float factor = lumens[unit] * (is_seen ? 1 : pi); /* layers have irradiance over pi */
    struct image image;
    *map = (struct heat_map){0};
    if (!renderer_read_some(renderer, is_seen ? seen : received, &image))
        return false;
    size_t count = (size_t)image.width * (size_t)image.height;
    float *values = mem_alloc(count, sizeof *values);
    for (size_t i = 0; i < count; i++)
        for (int c = 0; c + 2 < image.channel_count; c += 3) /* R G B of each layer, without A */
            values[i] += factor * rgb_luminance(image.pixels + i * (size_t)image.channel_count + c);
    *map = (struct heat_map){.title = titles[unit == LIGHT_WATTS][is_seen],
                             .width = image.width,
                             .height = image.height,
                             .values = values,
                             .top = top > 0 ? top : heat_map_fit_top(values, count)};
    image_free(&image);
    return true;
}

void false_colours_free(struct heat_map *map) {
    free((void *)map->values);
    *map = (struct heat_map){0};
}
