#include "viewer/panel/panel.h"

#include "base/file/folder.h"
#include "gl/memory.h"
#include "inspect/marks.h"
#include "passes/maps.h"
#include "passes/vpls.h"
#include "viewer/files/start.h"
#include "viewer/picture/legend.h"
#include "viewer/picture/look.h"
#include "viewer/picture/picture.h"
#include "viewer/reference/comparing.h"
#include "viewer/scene/lights.h"
#include "viewer/window/ui.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Passes of the frame have colours; their own parts share them. */
static uint32_t color_of(int n, int alpha) {
    unsigned char rgb[3];
    marks_cluster_color(n, rgb);
    return UI_RGBA(rgb[0], rgb[1], rgb[2], alpha);
}

static bool is_listed(const struct pace_pass *pass, bool all) {
    return pass->depth == 1 ? all || !pass->idle : pass->depth > 1 && all;
}

/* all: with the parts of passes, and those that did not run. */
static void draw_times(const struct pace *pace, bool all) {
    float frame = 1e-3F;
    int n = -1;
    for (int i = 0; i < pace->pass_count; i++)
        if (pace->passes[i].depth == 0)
            frame = pace_median(&pace->passes[i]);
    for (int i = 0; i < pace->pass_count; i++) {
        const struct pace_pass *pass = &pace->passes[i];
        uint32_t color = color_of(n += pass->depth == 1, pass->depth == 1 ? 150 : 70);
        float ms = pace_median(pass);
        if (!is_listed(pass, all))
            continue;
        if (pass->idle)
            ui_bar(color, path_name(pass->path), pass->depth - 1, 0, "%s",
                   pass->kept ? "kept" : "-");
        else
            ui_bar(color, path_name(pass->path), pass->depth - 1, ms / frame,
                   ms < 1000 ? "%.1f ms" : "%.2f s", (double)(ms < 1000 ? ms : ms / 1000));
    }
}

/* Each frame a column of its passes, those rendered smaller than the largest dim; a line where a
 * frame takes its budget. */
static void draw_graph(const struct pace *pace, float budget, float width, float height) {
    enum { COLUMNS = 80 };
    int count = pace->frame_count < COLUMNS ? pace->frame_count : COLUMNS;
    int first = pace->frame_count - count;
    float top = 1e-3F, pixels = 0, sums[COLUMNS] = {0};
    char axis[32];
    for (int i = 0; i < count; i++) {
        top = fmaxf(top, pace->frame_ms[first + i]);
        pixels = fmaxf(pixels, pace->frame_pixels[first + i]);
    }
    if (top < 1000)
        snprintf(axis, sizeof axis, top < 100 ? "%.1f ms" : "%.0f ms", (double)top);
    else
        snprintf(axis, sizeof axis, "%.2f s", (double)top / 1000);
    struct ui_graph graph = ui_graph_begin(width, height, axis);
    for (int p = 0, n = 0; p < pace->pass_count; p++) {
        const struct pace_pass *pass = &pace->passes[p];
        for (int i = 0; pass->depth == 1 && i < count; i++) {
            bool whole = pace->frame_pixels[first + i] >= pixels;
            float from = sums[i] / top;
            sums[i] += pass->history[first + i];
            ui_graph_column(&graph, i, COLUMNS, from, sums[i] / top,
                            color_of(n, whole ? 255 : 110));
        }
        n += pass->depth == 1;
    }
    for (int i = 0; budget > 0 && budget < top && i < COLUMNS; i++)
        ui_graph_column(&graph, i, COLUMNS, budget / top - .012F, budget / top + .012F,
                        UI_RGBA(255, 255, 255, 200));
}

/* Whether the table has room with the graph, and with all passes or with the topmost. */
static bool has_room(const struct viewer *viewer, bool all) {
    const struct pace *pace = &viewer->shown.pace;
    float line = ui_line_height(), row = 1.37F * line;
    float height = (float)viewer->shown.area.height - 2 * line;
    float rows = 11; /* besides passes, with the edges */
    for (int i = 0; i < pace->pass_count; i++)
        rows += is_listed(&pace->passes[i], all);
    return rows * row + 5 * line < height;
}

float overlay_width(const struct viewer *viewer) {
    static const float lines[] = {[OVERLAY_LINE] = 14, [OVERLAY_TABLE] = 19, [OVERLAY_NONE] = 0};
    return lines[viewer->panel.overlay] * ui_line_height();
}

static void draw_statistics(struct viewer *viewer) {
    const struct pace *pace = &viewer->shown.pace;
    const struct renderer_desc *desc = &viewer->shown.renderer.desc;
    float line = ui_line_height();
    float frame = pace->frame_count ? pace->frame_ms[pace->frame_count - 1] : 0;
    bool whole = viewer->panel.overlay == OVERLAY_TABLE;
    ui_area_begin("statistics", UI_OVERLAY, line, line, overlay_width(viewer) - 2 * line, 0);
    if (frame < 1000)
        ui_text(UI_NORMAL, "%.1f ms a frame", (double)frame);
    else
        ui_text(UI_NORMAL, "%.2f s a frame", (double)frame / 1000);
    if (!whole) {
        ui_area_end();
        return;
    }
    bool all = has_room(viewer, true);
    if (all || has_room(viewer, false))
        draw_graph(pace, viewer->wish.budget, 15.2F * line, 3.6F * line);
    draw_times(pace, all);
    ui_separator();
    double fps = pace_fps(pace, window_time());
    if (fps > 0)
        ui_value("pictures a second", "%.1f", fps);
    ui_value("faces", "%u", geometry_triangle_count(&viewer->document.geometry));
    struct output_list outputs;
    renderer_outputs(&viewer->shown.renderer, &outputs);
    const struct vpl_buffer *vpls = output_vpls(&outputs);
    const struct val_output *vals = output_vals(&outputs);
    if (vpls)
        ui_value("VPLs", "%d", vpls->count);
    if (vals)
        ui_value("VALs", "%d", vals->maps.views->count);
    ui_value("size", "%d x %d%s", desc->width, desc->height,
             viewer->shown.moving ? " while moving" : "");
    int passes = renderer_pass_count(&viewer->shown.renderer);
    if (passes > 0)
        ui_value("passes", "%d of %d", passes, viewer_passes(viewer));
    ui_value("GPU memory", "%.0f MiB", (double)gpu_memory_total() / (1 << 20));
    if (gl.software)
        ui_text(UI_WARNING, "software OpenGL: no GPU is used");
    ui_area_end();
}

static void draw_messages(struct viewer *viewer) {
    struct message recent[MESSAGES_SHOWN];
    int count = messages_recent(&viewer->host.messages, recent);
    float line = ui_line_height();
    if (count == 0)
        return;
    ui_area_begin("messages", UI_NOTE, line,
                  (float)viewer->host.input->height - line - timeline_height(viewer),
                  (float)viewer->shown.area.width - 2 * line, 0);
    for (int i = 0; i < count; i++)
        ui_text(recent[i].tone, "%s", recent[i].text);
    ui_area_end();
}

/* Above all in the picture, where what comes will be. */
static void draw_busy(const struct viewer *viewer) {
    const struct rectangle *area = &viewer->shown.area;
    const char *busy = viewer->shown.awaits ? busy_compiling : viewer->shown.busy;
    if (busy)
        ui_draw_label((float)area->x + .5F * (float)area->width,
                      (float)area->y + .5F * (float)area->height, .5F, busy);
}

static void draw_help(struct viewer *viewer) {
    const struct input *input = viewer->host.input;
    ui_page_begin("help", (float)input->width, (float)input->height, 72, 48);
    ui_text(UI_TITLE, "Keys and mouse");
    ui_separator();
    controls_draw_help();
    ui_area_end();
}

/* --- on the picture --- */

/* Where labels may stand. */
static float bottom_of(const struct viewer *viewer) {
    const struct rectangle *area = &viewer->shown.area, *picture = &viewer->shown.picture;
    float bottom = (float)(area->y + area->height);
    return fminf(bottom, (float)(picture->y + picture->height));
}

static const char *right_name(const struct viewer *viewer) {
    const struct compare *compare = &viewer->shown.compare;
    if (compare->mode != COMPARE_REFERENCE)
        return compare->technique->name;
    return viewer_reference_fits(viewer) ? "reference" : "reference of another view";
}

static const char *left_name(const struct viewer *viewer) {
    const struct compare *compare = &viewer->shown.compare;
    return compare->heat ? metrics[compare->heat_metric].name : viewer->wish.technique->name;
}

static void draw_line(const struct viewer *viewer, float x) {
    const struct rectangle *picture = &viewer->shown.picture;
    float top = (float)picture->y, bottom = top + (float)picture->height;
    ui_draw_line(x, top, x, bottom, UI_RGBA(0, 0, 0, 160), 3);
    ui_draw_line(x, top, x, bottom, UI_RGBA(255, 255, 255, 230), 1.2F);
    ui_draw_disc(x, .5F * (top + bottom), 7, UI_RGBA(255, 255, 255, 230));
}

/* Left and right of the line; where there is no room, in a row of its own. */
static void draw_names(const struct viewer *viewer, float x, float y) {
    const struct rectangle *area = &viewer->shown.area;
    float gap = .6F * ui_line_height(), above = y - 1.8F * ui_line_height();
    float start = (float)area->x, end = (float)(area->x + area->width);
    const char *left = left_name(viewer), *right = right_name(viewer);
    if (x - gap - ui_label_width(left) > start)
        ui_draw_label(x - gap, y, 1, left);
    else
        ui_draw_label(start + gap, above, 0, left);
    if (x + gap + ui_label_width(right) < end)
        ui_draw_label(x + gap, y, 0, right);
    else
        ui_draw_label(end - gap, above, 1, right);
}

/* What is compared, and where the two meet. */
static void draw_split(const struct viewer *viewer) {
    const struct rectangle *picture = &viewer->shown.picture, *area = &viewer->shown.area;
    const struct compare *compare = &viewer->shown.compare;
    float line = ui_line_height(), y = bottom_of(viewer) - 2 * line;
    float x = (float)picture->x + compare->split * (float)picture->width;
    if (!viewer->shown.right)
        return;
    ui_draw_clip((float)area->x, (float)area->y, (float)area->width, (float)area->height);
    if (compare->heat && compare->heat_map.id && !compare->only_right)
        legend_draw_scale(viewer, &compare->heat_scale, "", bottom_of(viewer) - 4 * line);
    if (compare->only_right) {
        ui_draw_label((float)(area->x + area->width) - line, y, 1, right_name(viewer));
    } else if (look_is_beside(viewer)) {
        draw_names(viewer, (float)(area->x + viewer->shown.room.width), y);
    } else if (viewer->look.layout == SCREEN_DIFFERENCE) {
        ui_draw_label((float)(area->x + area->width) - line, y, 1, "difference, 4 times as bright");
    } else {
        draw_line(viewer, x);
        draw_names(viewer, x, y);
    }
    ui_draw_unclip();
}

/* With the panel closed nothing else tells what was found: "lit by 8 groups: 27 %, 22 %, 9 %". */
static void draw_card(const struct viewer *viewer, float x, float y) {
    const struct pick *pick = &viewer->shown.pick;
    const struct rectangle *area = &viewer->shown.area;
    char text[96];
    int at = snprintf(text, sizeof text, "lit by %d group%s", pick->val_count,
                      pick->val_count == 1 ? "" : "s");
    for (int i = 0; i < pick->val_count && i < 3; i++)
        at += snprintf(text + at, sizeof text - (size_t)at, "%s %.0f %%", i ? "," : ":",
                       100 * (double)pick->vals[i].share);
    float gap = ui_line_height(), width = ui_label_width(text);
    bool has_room = x + gap + width < (float)(area->x + area->width);
    if (pick->val_count > 0 && !viewer->panel.is_open)
        ui_draw_label(has_room ? x + gap : x - gap, y - .7F * gap, has_room ? 0 : 1, text);
}

static void draw_pick(const struct viewer *viewer) {
    const struct rectangle *picture = &viewer->shown.picture;
    float place[2], aspect = (float)picture->width / (float)picture->height;
    if (!viewer->shown.has_pick || viewer->shown.choice.output ||
        !camera_project(&viewer->placed.orbit.camera, viewer->shown.pick.position, aspect, place) ||
        place[0] < 0 || place[0] > 1 || place[1] < 0 || place[1] > 1)
        return;
    float x = (float)picture->x + place[0] * (float)picture->width;
    float y = (float)picture->y + place[1] * (float)picture->height;
    /* Dark beside light: it is seen on walls of any colour. */
    ui_draw_ring(x, y, 9, UI_RGBA(0, 0, 0, 230), 7);
    ui_draw_ring(x, y, 9, UI_RGBA(255, 255, 255, 255), 2.5F);
    ui_draw_disc(x, y, 2.5F, UI_RGBA(0, 0, 0, 230));
    draw_card(viewer, x, y);
}

/* With the panel closed nothing else says what is shown. */
static void draw_output_name(const struct viewer *viewer) {
    const struct rectangle *area = &viewer->shown.area;
    const char *name = viewer->shown.choice.output;
    if (name && !viewer->panel.is_open)
        ui_draw_label((float)(area->x + area->width) - ui_line_height(),
                      (float)area->y + ui_line_height(), 1, name);
}

static void draw_enlargement(const struct viewer *viewer) {
    const struct rectangle *area = &viewer->shown.area;
    char text[32];
    snprintf(text, sizeof text, "%.0f %%", 100 * look_zoom(viewer));
    if (viewer->look.zoom > 0)
        ui_draw_label((float)area->x + .5F * (float)area->width,
                      (float)area->y + .5F * ui_line_height(), .5F, text);
}

static void draw_marks(const struct viewer *viewer) {
    draw_enlargement(viewer);
    draw_split(viewer);
    draw_output_name(viewer);
    legend_draw(viewer);
    draw_pick(viewer);
    if (viewer_has_light(viewer))
        light_tool_draw(&viewer->hand.light_tool,
                        &(struct light_stage){&viewer->placed.orbit.camera,
                                              &viewer->document.geometry, &viewer->shown.picture,
                                              viewer->host.input->scale},
                        &viewer->placed.emitters, viewer->placed.chosen_light);
}

void overlay_draw(struct viewer *viewer) {
    if (viewer->shown.left)
        draw_marks(viewer);
    if (viewer->panel.overlay != OVERLAY_NONE && viewer->has_scene)
        draw_statistics(viewer);
    draw_busy(viewer);
    start_draw(viewer);
    if (viewer->panel.help)
        draw_help(viewer);
    draw_messages(viewer);
}
