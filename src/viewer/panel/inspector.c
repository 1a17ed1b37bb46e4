#include "viewer/panel/panel.h"

#include "metrics/layer.h"
#include "viewer/picture/look.h"
#include "viewer/window/ui.h"

#include <math.h>
#include <string.h>

static bool read_renderer(struct viewer *viewer, struct renderer *renderer, int x, int y,
                          float rgb[3]) {
    struct image all = {0}, layer = {0};
    bool ok = x < renderer->desc.width && y < renderer->desc.height &&
              renderer_read_pixel(renderer, x, y, &all) &&
              layer_extract(&layer, &all, shown_layer_prefix(viewer->shown.layer));
    if (ok)
        memcpy(rgb, layer.pixels, 3 * sizeof *rgb);
    images_free(&all, &layer);
    return ok;
}

/* The reference's own pixel at that place, whatever its size is. */
static bool read_reference(const struct image *layer, float x, float y, float rgb[3]) {
    int column = (int)(x * (float)layer->width), row = (int)(y * (float)layer->height);
    if (!layer->pixels)
        return false;
    memcpy(rgb, image_at(layer, column, row), 3 * sizeof *rgb);
    return true;
}

static bool read_right(struct viewer *viewer, float x, float y, int column, int row, float rgb[3]) {
    struct compare *compare = &viewer->shown.compare;
    if (!viewer->shown.right)
        return false;
    return compare->mode == COMPARE_REFERENCE
               ? read_reference(&compare->reference.layer, x, y, rgb)
               : read_renderer(viewer, &compare->other, column, row, rgb);
}

/* Above on the right; where the times need that room, below, above what is compared. */
static void begin_area(const struct viewer *viewer, float width) {
    const struct rectangle *area = &viewer->shown.area;
    float line = ui_line_height(), x = (float)(area->x + area->width) - line - width;
    float below = (float)(area->y + area->height) - 4.2F * line;
    bool is_above = x >= (float)area->x + overlay_width(viewer);
    ui_area_begin("inspector", is_above ? UI_OVERLAY : UI_NOTE, x, is_above ? line : below, width,
                  0);
}

/* Of an output: its colour as it is shown, 0 to 1, and the surface where it has the picture's
 * pixels. */
static void draw_output(struct viewer *viewer, float x, float y, float width) {
    struct renderer *renderer = &viewer->shown.renderer;
    struct bitmap bitmap;
    struct pick pick;
    const struct heat_map *light = inspect_light(&viewer->shown.inspect, &viewer->shown.choice);
    float shown[3];
    texture_read_bitmap(viewer->shown.left, &bitmap);
    int column = (int)(x * (float)bitmap.width), row = (int)(y * (float)bitmap.height);
    bool is_of_picture =
        bitmap.width == renderer->desc.width && bitmap.height == renderer->desc.height;
    for (int c = 0; c < 3; c++)
        shown[c] =
            bitmap.rgba[4 * ((size_t)row * (size_t)bitmap.width + (size_t)column) + (size_t)c] /
            255.F;
    begin_area(viewer, width);
    ui_value(viewer->shown.choice.output, "%d, %d of %d x %d", column, row, bitmap.width,
             bitmap.height);
    if (light)
        ui_value(light->title, "%.4g", (double)light->values[row * light->width + column]);
    else
        ui_numbers("as shown", shown);
    if (is_of_picture && probe_pick(&viewer->shown.probe, renderer, x, y, &pick) && pick.present) {
        ui_numbers("position, m", pick.position);
        ui_numbers("normal", pick.normal);
        ui_numbers("albedo", pick.albedo);
    }
    ui_area_end();
    bitmap_free(&bitmap);
}

void inspector_draw(struct viewer *viewer) {
    const struct rectangle *area = &viewer->shown.area;
    struct renderer *renderer = &viewer->shown.renderer;
    float x, y, left[3], right[3], line = ui_line_height(), width = 21 * line;
    if (!viewer->look.inspects || !viewer->has_scene || viewer->shown.frame_count == 0 ||
        ui_wants_mouse() || !look_at_mouse(viewer, &x, &y))
        return;
    int column = (int)(x * (float)renderer->desc.width),
        row = (int)(y * (float)renderer->desc.height);
    if (viewer->shown.choice.output) {
        draw_output(viewer, x, y, fminf(width, (float)area->width - 2 * line));
        return;
    }
    if (!read_renderer(viewer, renderer, column, row, left))
        return;
    if (width > (float)area->width - 2 * line)
        width = (float)area->width - 2 * line;
    begin_area(viewer, width);
    ui_value("pixel", "%d, %d of %d x %d", column, row, renderer->desc.width,
             renderer->desc.height);
    ui_numbers(viewer->shown.right ? "left" : "radiance", left);
    if (read_right(viewer, x, y, column, row, right)) {
        ui_numbers("right", right);
        for (int c = 0; c < 3; c++)
            right[c] = left[c] - right[c];
        ui_numbers("left \xe2\x88\x92 right", right);
    }
    ui_area_end();
}
