#include "viewer/picture/legend.h"

#include "shared/inspect.h"
#include "viewer/window/ui.h"

#include <math.h>
#include <stdio.h>

/* A patch of colour with a border, as high as a line's letters; its width. */
static float draw_patch(float x, float y, uint32_t color) {
    float size = .8F * ui_line_height();
    ui_draw_rectangle(x - 1, y - 1, size + 2, size + 2, UI_RGBA(140, 147, 160, 255));
    ui_draw_rectangle(x, y, size, size, color);
    return size;
}

/* --- cells --- */

static uint32_t color_of_val(int k) {
    unsigned char rgb[3];
    marks_cluster_color(k, rgb);
    return UI_RGBA(rgb[0], rgb[1], rgb[2], 255);
}

/* Its number, in the lower left corner; of a VAL with the colour that it has everywhere. */
static void draw_cell(int layer, bool is_val, float left, float bottom) {
    float line = ui_line_height(), x = left + .4F * line, y = bottom - 1.75F * line;
    char number[16];
    snprintf(number, sizeof number, "%d", layer);
    ui_draw_label(x, y, 0, number);
    if (is_val)
        draw_patch(x + ui_label_width(number) + .2F * line, y + .28F * line, color_of_val(layer));
}

/* Where cells are too small for numbers the colours alone would tell little: neither is there. */
static void draw_cells(const struct viewer *viewer, const struct sheet *sheet, bool is_val) {
    const struct rectangle *picture = &viewer->shown.picture;
    float line = ui_line_height();
    float width = (float)picture->width / (float)sheet->columns;
    float height = (float)picture->height / (float)sheet->rows;
    if (width < 3.6F * line || height < 2.2F * line)
        return;
    for (int i = 0; i < sheet->layers; i++)
        draw_cell(i, is_val, (float)picture->x + width * (float)(i % sheet->columns),
                  (float)picture->y + height * (float)(i / sheet->columns + 1));
}

/* --- colours --- */

static const struct meaning {
    const char *text;
    float color[3], dimmed;
} shadow_colors[] = {
    {"lit by the VAL", {INSPECT_LIT}, 1},
    {"in its shadow", {INSPECT_LIT}, INSPECT_SHADOW},
    {"behind it, or turned away", {INSPECT_TURNED_AWAY}, 1},
};

enum { MEANINGS = sizeof shadow_colors / sizeof *shadow_colors };

static uint32_t color_of(const struct meaning *meaning) {
    int rgb[3];
    for (int c = 0; c < 3; c++)
        rgb[c] = (int)lrintf(255 * meaning->dimmed * meaning->color[c]);
    return UI_RGBA(rgb[0], rgb[1], rgb[2], 255);
}

static float width_of(const struct meaning *meaning) {
    return ui_label_width(meaning->text) + 1.6F * ui_line_height();
}

/* Of all of them beside each other, where there is room; 0: below each other. */
static float row_width(const struct viewer *viewer) {
    float width = 0;
    for (int i = 0; i < MEANINGS; i++)
        width += width_of(&shadow_colors[i]);
    return width < (float)viewer->shown.area.width ? width : 0;
}

static float meanings_height(const struct viewer *viewer) {
    return (row_width(viewer) > 0 ? 1 : (float)MEANINGS) * 1.6F * ui_line_height();
}

float legend_height(const struct viewer *viewer) {
    const struct inspect_choice *choice = &viewer->shown.choice;
    const struct renderer *renderer = &viewer->shown.renderer;
    struct sheet sheet;
    if (!choice->output || !inspect_is(renderer, choice->output, OUTPUT_VISIBILITY) ||
        !inspect_sheet(renderer, choice, &sheet))
        return 0;
    return meanings_height(viewer);
}

/* In the middle of the lower edge, or below each other from the left. */
static void draw_meanings(const struct viewer *viewer) {
    const struct rectangle *area = &viewer->shown.area;
    float line = ui_line_height(), width = row_width(viewer);
    float x = (float)area->x + (width > 0 ? .5F * ((float)area->width - width) : .6F * line);
    float y = (float)(area->y + area->height) - meanings_height(viewer) + .1F * line;
    for (int i = 0; i < MEANINGS; i++) {
        float patch = draw_patch(x, y + .28F * line, color_of(&shadow_colors[i]));
        ui_draw_label(x + patch + .2F * line, y, 0, shadow_colors[i].text);
        if (width > 0)
            x += width_of(&shadow_colors[i]);
        else
            y += 1.6F * line;
    }
}

void legend_draw_scale(const struct viewer *viewer, const struct heat_map *scale, const char *unit,
                       float y) {
    enum { STEPS = 60 };
    float line = ui_line_height(), step = 8 * line / STEPS;
    float x = fmaxf((float)viewer->shown.picture.x, 0) + 4.5F * line;
    float lowest = scale->is_signed ? -scale->top : 0;
    char text[32];
    for (int i = 0; i < STEPS; i++) {
        unsigned char c[3];
        heat_map_color(scale, lowest + (scale->top - lowest) * ((float)i + .5F) / STEPS, c);
        ui_draw_rectangle(x + (float)i * step, y, step + 1, 1.35F * line,
                          UI_RGBA(c[0], c[1], c[2], 255));
    }
    snprintf(text, sizeof text, "%g", (double)lowest);
    ui_draw_label(x - .3F * line, y, 1, text);
    snprintf(text, sizeof text, *unit ? "%g %s" : "%g", (double)scale->top, unit);
    ui_draw_label(x + 8.3F * line, y, 0, text);
}

void legend_draw(const struct viewer *viewer) {
    const struct rectangle *area = &viewer->shown.area;
    const struct inspect_choice *choice = &viewer->shown.choice;
    const struct renderer *renderer = &viewer->shown.renderer;
    struct sheet sheet;
    if (!choice->output)
        return;
    bool is_val = inspect_is(renderer, choice->output, OUTPUT_VISIBILITY);
    ui_draw_clip((float)area->x, (float)area->y, (float)area->width, (float)area->height);
    if (inspect_sheet(renderer, choice, &sheet))
        draw_cells(viewer, &sheet, is_val);
    if (is_val)
        draw_meanings(viewer);
    const struct heat_map *light = inspect_light(&viewer->shown.inspect, choice);
    if (light)
        legend_draw_scale(viewer, light, light->title,
                          (float)(area->y + area->height) - 2 * ui_line_height());
    ui_draw_unclip();
}
