/* The widgets of the viewer, immediate: each call draws one and tells what the user did with it.
 *
 * A thin bridge to Dear ImGui, which is named in ui.cpp alone, with a look of our own. One user
 * interface a process. Lengths and positions are pixels of the framebuffer, y down. */
#ifndef VIEWER_WINDOW_UI_H
#define VIEWER_WINDOW_UI_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

struct input; /* viewer/window/window.h */

/* Starts the interface for a window whose context is current. Error: of the graphics driver. */
bool ui_init(void *native_window, float scale);
void ui_free(void); /* accepts one that is not started, or failed half-way */

/* Begin and end a frame; all widgets lie between. ui_frame_end draws them into the window's
 * framebuffer. */
void ui_frame_begin(const struct input *input);
void ui_frame_end(void);

/* ui_note_places starts a list of places for scripts that press widgets. ui_places returns it: a
 * line "x y width height name" per widget with a visible middle. Valid until the next frame
 * begins. */
void ui_note_places(void);
const char *ui_places(void);

/* Return true if mouse or keys belong to a widget, not to the picture. Keys belong to a panel,
 * too, from Tab, which steps through its widgets, to Esc or a click. */
bool ui_wants_mouse(void);
bool ui_wants_keys(void);

/* Returns true while a clicked field opens, which takes some frames. Hold back typed text
 * meanwhile. */
bool ui_is_opening_field(void);

/* Closes the open list of choices. Returns true if there was one. */
bool ui_close_popup(void);

/* Sets the cursor until the next frame, in place of the arrow. */
enum ui_cursor { UI_CURSOR_HAND, UI_CURSOR_SIDEWAYS };
void ui_show_cursor(enum ui_cursor cursor);

/* Returns the height of a line of text, pixels: the unit of the layout. */
float ui_line_height(void);

/* --- areas --- */

enum ui_area {
    UI_PANEL,   /* opaque, scrolls */
    UI_PAGE,    /* as UI_PANEL, with a border, above all others */
    UI_OVERLAY, /* transparent, lets the mouse pass, sized by its contents */
    UI_NOTE,    /* as UI_OVERLAY, above the point x y */
    UI_BAR,     /* opaque, does not scroll */
    UI_DIALOG,  /* opaque, sized by its contents, centred at x y */
};

void ui_area_begin(const char *id, enum ui_area kind, float x, float y, float width, float height);
void ui_area_end(void);

/* Begins a UI_PAGE in the middle of a window: lines_wide x lines_high lines of text, or as much
 * as fits. ui_area_end ends it. */
void ui_page_begin(const char *id, float window_width, float window_height, float lines_wide,
                   float lines_high);

/* Draws a heading that opens and closes. Returns true if it is open. */
bool ui_section(const char *title, bool open_at_first);

/* Opens the section of that title at its next drawing. */
void ui_open_section(const char *title);

/* Scrolls the area so that the next widget stands at its top. */
void ui_show_here(void);

/* Draws a small title within a section. */
void ui_heading(const char *title);

/* ui_separator draws a thin line with space around it. */
void ui_separator(void);
void ui_space(void);

/* Places the next widget beside the previous one. */
void ui_same_line(void);

/* Widgets between these are grey and do not react, if disabled. */
void ui_disabled_begin(bool disabled);
void ui_disabled_end(void);

/* --- text --- */

enum ui_tone { UI_NORMAL, UI_DIM, UI_WARNING, UI_ERROR, UI_TITLE };

void ui_text(enum ui_tone tone, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Draws a name on the left and its value on the right. */
void ui_value(const char *name, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* As ui_value, with an explanation while the mouse rests on it. */
void ui_fact(const char *name, const char *help, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* Draws a text at the right end of the line. */
void ui_text_right(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* Draws a name on the left, and three numbers in columns on the right. */
void ui_numbers(const char *name, const float values[3]);

/* Draw two columns, one below the other if the area is narrow. ui_columns_next begins the
 * second. */
void ui_columns_begin(const char *id);
void ui_columns_next(void);
void ui_columns_end(void);

/* Draws a term, and its meaning in a second column. */
void ui_definition(const char *term, const char *meaning);

/* --- rows: a name, a widget, and an arrow back to the default --- */

struct ui_row {
    const char *name;
    const char *help;  /* shown while the mouse rests on it; NULL: none */
    bool differs;      /* differs from the default: has the arrow */
    const char *least; /* text for the least value of a slider; NULL: the number */
    bool even;         /* linear slider, even for a wide range */
    const char *scope; /* distinguishes rows of the same name; NULL: "" */
};

enum ui_result { UI_NOTHING, UI_CHANGED, UI_RESET };

enum ui_result ui_flag(const struct ui_row *row, bool *value);
enum ui_result ui_int(const struct ui_row *row, int *value, int minimum, int maximum);
enum ui_result ui_float(const struct ui_row *row, float *value, float minimum, float maximum);
enum ui_result ui_choice(const struct ui_row *row, int *value, const char *const *names, int count);

/* Draws a number with two decimals. Dragging changes it by `step` per pixel, ten times that with
 * Shift; a double click types it. */
enum ui_result ui_drag(const struct ui_row *row, float *value, float minimum, float maximum,
                       float step);

/* Draws three numbers. Dragging changes them by `step` per pixel. */
enum ui_result ui_vector(const struct ui_row *row, float value[3], float step);

/* Draws a patch of a linear R G B colour, 0 to 1, that opens a colour wheel. */
enum ui_result ui_color(const struct ui_row *row, float value[3]);

/* Draws a slider from 0 to `most`, as wide as the area. Returns true if it was moved. */
bool ui_scrub(const char *id, float *value, float most);

/* Draws a field of text. Returns UI_CHANGED on Enter. */
enum ui_result ui_text_field(const struct ui_row *row, char *text, size_t size, const char *hint);

/* --- others --- */

bool ui_button(const char *name, const char *help);

/* Draws a button as wide as the area. Returns true if it was pressed. */
bool ui_wide_button(const char *name, const char *help);

/* Draws buttons side by side, one of them on. Returns true if another was chosen. */
bool ui_segments(const char *id, int *value, const char *const *names, int count);

/* As ui_segments, with an explanation for each. */
bool ui_explained_segments(const char *id, int *value, const char *const *names,
                           const char *const *helps, int count);

/* Draws a line with a patch of colour (0: none), a name, two texts in columns, and a bar behind
 * them for `share` (0 to 1). Returns true if it was clicked. */
bool ui_list_item(uint32_t color, const char *name, const char *middle, const char *right,
                  float share, bool chosen);

/* Draws a name and a value with a bar behind them for `share` (0 to 1). */
void ui_bar(uint32_t color, const char *name, int indent, float share, const char *format, ...)
    __attribute__((format(printf, 5, 6)));

/* Area of a column chart. */
struct ui_graph {
    float x, y, width, height;
};

struct ui_graph ui_graph_begin(float width, float height, const char *top);

/* Draws a part of column n of `count`, from 0 (bottom) to 1 (top). */
void ui_graph_column(const struct ui_graph *graph, int n, int count, float from, float to,
                     uint32_t color);

/* --- drawing on the picture, below all areas; or on a canvas, between its begin and end --- */

/* An area to draw on, as wide as its parent. */
struct ui_canvas {
    float x, y, width, height;
};

void ui_canvas_begin(const char *name, float height, struct ui_canvas *canvas);
void ui_canvas_end(void);

#define UI_RGBA(r, g, b, a)                                                                        \
    ((uint32_t)(a) << 24 | (uint32_t)(b) << 16 | (uint32_t)(g) << 8 | (uint32_t)(r))

void ui_draw_clip(float x, float y, float width, float height);
void ui_draw_unclip(void);
void ui_draw_line(float x0, float y0, float x1, float y1, uint32_t color, float thickness);
void ui_draw_disc(float x, float y, float radius, uint32_t color);
void ui_draw_ring(float x, float y, float radius, uint32_t color, float thickness);
void ui_draw_rectangle(float x, float y, float width, float height, uint32_t color);

/* Draws a text; `align` as in ui_draw_label. */
void ui_draw_text(float x, float y, float align, enum ui_tone tone, const char *text);

/* Draws a text on a dark background. align 0: x is its left edge, 1: its right edge.
 * ui_label_width returns its width, pixels. */
void ui_draw_label(float x, float y, float align, const char *text);
float ui_label_width(const char *text);

#ifdef __cplusplus
}
#endif

#endif
