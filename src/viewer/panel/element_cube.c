#include "viewer/panel/element_cube.h"

#include "inspect/marks.h"
#include "metrics/colour.h"
#include "viewer/window/ui.h"

#include <math.h>
#include <stdio.h>

enum { LEVELS_MAX = 12 };

/* Column and row of each face in the cross. */
static const int places[ELEMENT_FACES][2] = {
    [ELEMENT_LEFT] = {0, 1}, [ELEMENT_FRONT] = {1, 1}, [ELEMENT_RIGHT] = {2, 1},
    [ELEMENT_REAR] = {3, 1}, [ELEMENT_ABOVE] = {1, 0}, [ELEMENT_BELOW] = {1, 2},
};

static uint32_t level_color(int level, int alpha) {
    unsigned char rgb[3];
    marks_cluster_color(level, rgb);
    return UI_RGBA(rgb[0], rgb[1], rgb[2], alpha);
}

static uint32_t light_color(const struct element_bin *bin, float exposure) {
    int color[3];
    for (int c = 0; c < 3; c++)
        color[c] = (int)lrintf(255 * srgb_encode(exposure * bin->radiance[c]));
    return UI_RGBA(color[0], color[1], color[2], 255);
}

/* exposure 0: levels in place of light. */
static uint32_t bin_color(const struct element_bin *bin, float exposure) {
    switch (bin->kind) {
    case ELEMENT_BIN_HIDDEN:
        return UI_RGBA(40, 40, 40, 255);
    case ELEMENT_BIN_OPEN:
        return UI_RGBA(70, 90, 120, 255);
    case ELEMENT_BIN_BACK:
        return UI_RGBA(0, 0, 0, 255);
    case ELEMENT_BIN_LINKED:
        break;
    }
    return exposure > 0 ? light_color(bin, exposure) : level_color(bin->level, 255);
}

static void draw_cross(const struct element_view *view, float x, float y, float face,
                       float exposure) {
    const int side = view->side;
    float cell = face / (float)side;
    for (int i = 0; i < ELEMENT_FACES * side * side; i++) {
        const int *place = places[i / (side * side)];
        float across = (float)place[0] * face + (float)(i % side) * cell;
        float down = (float)place[1] * face + (float)(i / side % side) * cell;
        ui_draw_rectangle(x + across, y + down, cell, cell, bin_color(&view->bins[i], exposure));
    }
    for (int f = 0; f < ELEMENT_FACES; f++) {
        float left = x + (float)places[f][0] * face, top = y + (float)places[f][1] * face;
        ui_draw_line(left, top, left + face, top, UI_RGBA(255, 255, 255, 90), 1);
        ui_draw_line(left, top, left, top + face, UI_RGBA(255, 255, 255, 90), 1);
    }
}

static void draw_levels(const struct element_view *view) {
    const int count = ELEMENT_FACES * view->side * view->side;
    int levels[LEVELS_MAX] = {0}, linked = 0;
    for (int i = 0; i < count; i++)
        if (view->bins[i].kind == ELEMENT_BIN_LINKED && view->bins[i].level < LEVELS_MAX) {
            levels[view->bins[i].level]++;
            linked++;
        }
    for (int level = 0; level < LEVELS_MAX; level++) {
        char name[40];
        if (levels[level] == 0)
            continue;
        snprintf(name, sizeof name, level ? "links to nodes, level %d" : "links to elements",
                 level);
        ui_bar(level_color(level, 255), name, 0, (float)levels[level] / (float)linked, "%d",
               levels[level]);
    }
}

void element_cube_draw(const struct viewer *viewer) {
    const struct element_view *view = &viewer->shown.element;
    float line = ui_line_height(), exposure = exp2f(renderer_exposure(&viewer->shown.renderer));
    struct ui_canvas canvas;
    if (view->side == 0)
        return;
    ui_space();
    ui_fact(
        "surface element",
        "its bins as an unfolded cube, above it what lies before the surface: the light of each "
        "bin's partner, and the partner's level in the tree; grey-blue: no partner; black: a "
        "back",
        "6 x %d x %d bins", view->side, view->side);
    ui_numbers("element at, m", view->position);
    ui_numbers("irradiance", view->irradiance);
    ui_canvas_begin("element cube", 9.5F * line, &canvas);
    float face = fminf(canvas.width / 8.6F, 2.6F * line), y = canvas.y + .3F * line;
    for (int half = 0; half < 2; half++) {
        float x = canvas.x + (half ? canvas.width - 4 * face : 0);
        draw_cross(view, x, y, face, half ? 0 : exposure);
        ui_draw_text(x + 2 * face, y + 3 * face + .2F * line, .5F, UI_DIM,
                     half ? "levels of partners" : "light of partners");
    }
    ui_canvas_end();
    draw_levels(view);
}

static bool project(const struct viewer *viewer, const float position[3], float at[2]) {
    const struct rectangle *picture = &viewer->shown.picture;
    float aspect = (float)picture->width / (float)picture->height;
    if (!camera_project(&viewer->placed.orbit.camera, position, aspect, at))
        return false;
    at[0] = (float)picture->x + at[0] * (float)picture->width;
    at[1] = (float)picture->y + at[1] * (float)picture->height;
    return true;
}

void element_cube_draw_links(const struct viewer *viewer) {
    const struct element_view *view = &viewer->shown.element;
    const struct rectangle *area = &viewer->shown.area;
    float from[2], to[2];
    if (view->side == 0 || !project(viewer, view->position, from))
        return;
    ui_draw_clip((float)area->x, (float)area->y, (float)area->width, (float)area->height);
    for (int i = 0; i < ELEMENT_FACES * view->side * view->side; i++) {
        const struct element_bin *bin = &view->bins[i];
        if (bin->kind != ELEMENT_BIN_LINKED || !project(viewer, bin->partner, to))
            continue;
        ui_draw_line(from[0], from[1], to[0], to[1], level_color(bin->level, 90), 1);
        ui_draw_disc(to[0], to[1], 2, level_color(bin->level, 255));
    }
    ui_draw_unclip();
}
