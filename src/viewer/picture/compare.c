#include "viewer/picture/compare.h"

#include "base/error.h"
#include "base/memory.h"
#include "metrics/layer.h"

#include <stdlib.h>
#include <string.h>

void compare_forget(struct compare *compare) {
    if (compare->has_other)
        renderer_free(&compare->other);
    compare->has_other = false;
}

void compare_free(struct compare *compare) {
    compare_forget(compare);
    reference_free(&compare->reference);
    texture_free(&compare->heat_map);
}

/* --- the right picture --- */

static bool give_up(struct compare *compare) {
    compare_forget(compare);
    compare->mode = COMPARE_OFF;
    return error_prefix("the right picture");
}

bool compare_follow(struct compare *compare, const struct renderer *renderer, bool coarse,
                    bool waits) {
    struct renderer_desc desc = renderer->desc;
    if (compare->mode != COMPARE_TECHNIQUE)
        compare_forget(compare);
    if (compare->mode != COMPARE_TECHNIQUE || (waits && !compare->has_other))
        return true;
    desc.technique = waits ? compare->other.desc.technique : compare->technique;
    desc.settings = waits ? compare->other.desc.settings : compare->settings;
    desc.timed = false;
    if (coarse)
        renderer_settings_roughen(&desc.settings);
    if (!compare->has_other)
        compare->has_other = renderer_init(&compare->other, &desc);
    if (!compare->has_other)
        return give_up(compare);
    if (renderer_follow(&compare->other, &desc))
        return true;
    compare->technique = compare->other.desc.technique;
    renderer_settings_copy_but_samples(&compare->settings, &compare->other.desc.settings);
    return error_prefix("the right picture");
}

bool compare_render(struct compare *compare) {
    compare->measured = false;
    if (compare->mode != COMPARE_TECHNIQUE || !compare->has_other)
        return true;
    if (!renderer_update(&compare->other))
        return give_up(compare);
    renderer_render(&compare->other);
    return true;
}

const struct texture *compare_compose(struct compare *compare, const struct renderer *renderer,
                                      int layer) {
    switch (compare->mode) {
    case COMPARE_TECHNIQUE:
        if (!compare->has_other)
            return NULL;
        renderer_compose(&compare->other, layer);
        return &compare->other.composite.display;
    case COMPARE_REFERENCE:
        if (!compare->reference.framebuffer ||
            !reference_show(&compare->reference, shown_layer_prefix(layer),
                            &renderer->desc.settings))
            return NULL;
        return &compare->reference.display;
    case COMPARE_OFF:
    case COMPARE_MODES:
        break;
    }
    return NULL;
}

/* --- errors --- */

static bool read_layer(struct renderer *renderer, int layer, struct image *rgb) {
    struct image all = {0};
    *rgb = (struct image){0};
    bool ok =
        renderer_read_layers(renderer, &all) && layer_extract(rgb, &all, shown_layer_prefix(layer));
    image_free(&all);
    return ok;
}

static bool draw_heat(struct compare *compare, const struct comparison *comparison) {
    const struct metric *metric = &metrics[compare->heat_metric];
    int width = comparison->reference->width, height = comparison->reference->height;
    size_t count = (size_t)width * (size_t)height;
    struct bitmap picture;
    compare->heat_drawn = true;
    texture_free(&compare->heat_map);
    if (!compare->heat)
        return true;
    float *values = mem_alloc(count, sizeof *values);
    metric_measure(metric, comparison, values);
    struct heat_map map = {
        .title = metric->name,
        .width = width,
        .height = height,
        .values = values,
        .top = metric->range == RANGE_UNIT ? 1 : heat_map_fit_top(values, count),
        .is_signed = metric->range == RANGE_SIGNED,
    };
    heat_map_draw_values(&map, &picture);
    free(values);
    map.values = NULL;
    compare->heat_scale = map;
    bool ok = texture_init_bitmap(&compare->heat_map, "heat map", &picture);
    bitmap_free(&picture);
    return ok;
}

bool compare_has_metric(int metric) {
    return metrics[metric].pixel_error != NULL;
}

static bool measure(struct compare *compare, const struct comparison *comparison) {
    const struct image *test = comparison->test, *reference = comparison->reference;
    if (test->width != reference->width || test->height != reference->height)
        return error_set("the reference is %dx%d, the picture %dx%d", reference->width,
                         reference->height, test->width, test->height);
    for (int i = 0; i < METRIC_COUNT && !compare->measured; i++)
        if (compare_has_metric(i))
            compare->values[i] = metric_measure(&metrics[i], comparison, NULL);
    return draw_heat(compare, comparison);
}

bool compare_measure(struct compare *compare, struct renderer *renderer, int layer) {
    struct image left, right = {0};
    bool ok = read_layer(renderer, layer, &left);
    if (ok && compare->mode == COMPARE_TECHNIQUE)
        ok = read_layer(&compare->other, layer, &right);
    const struct comparison comparison = {
        .test = &left,
        .reference = compare->mode == COMPARE_TECHNIQUE ? &right : &compare->reference.layer,
    };
    ok = ok && measure(compare, &comparison);
    compare->measured = compare->heat_drawn = true;
    compare->has_values = ok;
    compare->heat &= ok;
    images_free(&left, &right);
    return ok;
}
