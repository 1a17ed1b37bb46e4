/* Draws the profile of a light as polar curves. The axis points down; the first plane of a name is
 * on the right. */
#include "metrics/colour.h"
#include "viewer/panel/panel.h"

#include <cglm/util.h>
#include <math.h>
#include <stdio.h>

enum { STEPS = 180, COUNT = 2 * STEPS + 1 }; /* of half a turn, on both sides */

struct polar {
    float x, y, scale; /* pixels per cd */
};

/* Of a step: from -180 to 180 degrees away from the axis. */
static float away_of(int step) {
    return GLM_PIf * (float)(step - STEPS) / STEPS;
}

static void draw_curve(const struct polar *polar, const float candela[COUNT], uint32_t color,
                       float thickness) {
    float x[2], y[2];
    for (int i = 0; i < COUNT; i++) {
        x[i % 2] = polar->x + polar->scale * candela[i] * sinf(away_of(i));
        y[i % 2] = polar->y + polar->scale * candela[i] * cosf(away_of(i));
        if (i > 0)
            ui_draw_line(x[0], y[0], x[1], y[1], color, thickness);
    }
}

/* Rings at half and all of the scale, axes, and their numbers. */
static void draw_scale(const struct polar *polar, float top) {
    const uint32_t grey = UI_RGBA(74, 80, 92, 255);
    float line = ui_line_height(), x = polar->x, y = polar->y, r = polar->scale * top;
    float ring[COUNT];
    char text[32];
    for (int half = 1; half <= 2; half++) {
        for (int i = 0; i < COUNT; i++)
            ring[i] = .5F * (float)half * top;
        draw_curve(polar, ring, grey, 1);
        snprintf(text, sizeof text, "%g cd", (double)ring[0]);
        ui_draw_text(x + .2F * line, y - polar->scale * ring[0], 0, UI_DIM, text);
    }
    ui_draw_line(x - r, y, x + r, y, grey, 1);
    ui_draw_line(x, y - r, x, y + r, grey, 1);
    ui_draw_text(x, y + r, .5F, UI_DIM, "0\xc2\xb0");
    ui_draw_text(x + r + .2F * line, y - .6F * line, 0, UI_DIM, "90\xc2\xb0");
    ui_draw_text(x, y - r - 1.2F * line, .5F, UI_DIM, "180\xc2\xb0");
}

void panel_draw_profile(const struct emitter *light) {
    static const char *const names[] = {"C90-C270", "C0-C180"};
    static const uint32_t colors[] = {UI_RGBA(240, 168, 72, 255), UI_RGBA(108, 182, 255, 255)};
    static const float thick[] = {3.5F, 1.5F}; /* curves that are equal are both seen */
    float candela[2][COUNT], most = 0, line = ui_line_height();
    struct ui_canvas canvas;
    for (int i = 0; i < 2 * COUNT; i++) {
        float rgb[3], *own = &candela[i / COUNT][i % COUNT];
        emitter_intensity(light, away_of(i % COUNT), i < COUNT ? GLM_PI_2f : 0, rgb);
        *own = rgb_luminance(rgb);
        most = fmaxf(most, *own);
    }
    ui_value("profile, greatest", "%.4g cd", (double)most);
    ui_canvas_begin("profile", 14 * line, &canvas);
    float digit = powf(10, floorf(log10f(fmaxf(most, 1e-6F))));
    float top = digit * fmaxf(ceilf(most / digit), 1); /* of one digit */
    struct polar polar = {canvas.x + .5F * canvas.width, canvas.y + .5F * canvas.height,
                          (.5F * canvas.height - 1.4F * line) / top};
    draw_scale(&polar, top);
    for (int i = 0; i < 2; i++) {
        float y = canvas.y + (.7F + 1.3F * (float)i) * line;
        draw_curve(&polar, candela[i], colors[i], thick[i]);
        ui_draw_line(canvas.x, y, canvas.x + line, y, colors[i], thick[i]);
        ui_draw_text(canvas.x + 1.4F * line, y - .6F * line, 0, UI_NORMAL, names[i]);
    }
    ui_canvas_end();
}
