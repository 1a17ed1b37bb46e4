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

/* For a window whose context is current. Error: the graphics driver. */
bool ui_init(void *native_window, float scale);
void ui_free(void); /* accepts what was not begun, or failed half-way */

/* All widgets lie between these. end draws them into the window's framebuffer. */
void ui_frame_begin(const struct input *input);
void ui_frame_end(void);

/* From then on, where the widgets whose middle can be seen lie, by name: a line "x y width height
 * name" for each of the frame, for scripts that press them. Valid until the next frame begins. */
void ui_note_places(void);
const char *ui_places(void);

/* Whether the mouse is over a widget, or text is typed into one: then it is not the picture's. Keys
 * are a panel's, too, from Tab, which goes through its widgets, to Esc or a click. */
bool ui_wants_mouse(void);
bool ui_wants_keys(void);

/* Whether a click has begun to open a field to type in, which takes some frames: what is typed is
 * to wait. */
bool ui_is_opening_field(void);

/* Closes the list of choices that is open; whether there was one. */
bool ui_close_popup(void);

/* In place of the arrow, until the next frame. */
enum ui_cursor { UI_CURSOR_HAND, UI_CURSOR_SIDEWAYS };
void ui_show_cursor(enum ui_cursor cursor);

/* The unit of the layout: pixels a line of text takes. */
float ui_line_height(void);

/* --- areas --- */

enum ui_area {
    UI_PANEL,   /* opaque, scrolls */
    UI_PAGE,    /* the same with a border, above all others */
    UI_OVERLAY, /* see-through, lets the mouse pass; as large as what is in it */
    UI_NOTE,    /* the same, above the point x y */
    UI_BAR,     /* opaque, does not scroll */
    UI_DIALOG,  /* opaque; as large as what is in it, about the point x y */
};

void ui_area_begin(const char *id, enum ui_area kind, float x, float y, float width, float height);
void ui_area_end(void);

/* A UI_PAGE in the middle of a window of that size: so many lines wide and high, or as much as
 * there is room for. ui_area_end ends it. */
void ui_page_begin(const char *id, float window_width, float window_height, float lines_wide,
                   float lines_high);

/* A heading that opens and closes; whether it is open. */
bool ui_section(const char *title, bool open_at_first);

/* Opens the section of that title when it is drawn next. */
void ui_open_section(const char *title);

/* Scrolls the area so that what comes next stands at its top. */
void ui_show_here(void);

/* A small title within a section. */
void ui_heading(const char *title);

/* A thin line with space around. */
void ui_separator(void);
void ui_space(void);

/* What follows stands beside what came before. */
void ui_same_line(void);

/* What follows is shown grey and does not react. */
void ui_disabled_begin(bool disabled);
void ui_disabled_end(void);

/* --- text --- */

enum ui_tone { UI_NORMAL, UI_DIM, UI_WARNING, UI_ERROR, UI_TITLE };

void ui_text(enum ui_tone tone, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* A name on the left and its value on the right. */
void ui_value(const char *name, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* The same with an explanation where the mouse rests on it. */
void ui_fact(const char *name, const char *help, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* At the right end of the line. */
void ui_text_right(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* A name on the left, and three numbers in columns on the right. */
void ui_numbers(const char *name, const float values[3]);

/* Two columns, one below the other where the area is narrow; next begins the second. */
void ui_columns_begin(const char *id);
void ui_columns_next(void);
void ui_columns_end(void);

/* A term, and its meaning in a column of its own. */
void ui_definition(const char *term, const char *meaning);

/* --- rows: a name, a widget, and an arrow back to the default --- */

struct ui_row {
    const char *name;
    const char *help;  /* shown while the mouse rests on it; NULL = none */
    bool differs;      /* from the default: the arrow is there */
    const char *least; /* written in place of the least number of a slider; NULL = the number */
    bool even;         /* a slider moves evenly, however wide its range */
    const char *scope; /* tells rows of the same name apart; NULL = "" */
};

enum ui_result { UI_NOTHING, UI_CHANGED, UI_RESET };

enum ui_result ui_flag(const struct ui_row *row, bool *value);
enum ui_result ui_int(const struct ui_row *row, int *value, int minimum, int maximum);
enum ui_result ui_float(const struct ui_row *row, float *value, float minimum, float maximum);
enum ui_result ui_choice(const struct ui_row *row, int *value, const char *const *names, int count);

/* A number with two decimals that is dragged, by this much a pixel, ten times with Shift; two
 * clicks type it. */
enum ui_result ui_drag(const struct ui_row *row, float *value, float minimum, float maximum,
                       float step);

/* Three numbers that are dragged, by this much a pixel. */
enum ui_result ui_vector(const struct ui_row *row, float value[3], float step);

/* Linear R G B, 0 to 1: a patch that opens a wheel of colours. */
enum ui_result ui_color(const struct ui_row *row, float value[3]);

/* A bar from 0 to most, as wide as the area; whether it was moved. */
bool ui_scrub(const char *id, float *value, float most);

/* A text; UI_CHANGED when Enter was pressed. */
enum ui_result ui_text_field(const struct ui_row *row, char *text, size_t size, const char *hint);

/* --- others --- */

bool ui_button(const char *name, const char *help);

/* A button as wide as the area. */
bool ui_wide_button(const char *name, const char *help);

/* A picture with a name below, to be clicked; texture 0: there is none yet. */
bool ui_tile(const char *name, unsigned texture, float width, float height, const char *help);

/* Buttons side by side of which one is on; whether another was chosen. */
bool ui_segments(const char *id, int *value, const char *const *names, int count);

/* The same, each with an explanation. */
bool ui_explained_segments(const char *id, int *value, const char *const *names,
                           const char *const *helps, int count);

/* A line that can be chosen: a patch of colour, a name, and two texts in columns of their own; a
 * share as a bar behind. */
bool ui_list_item(uint32_t color, const char *name, const char *middle, const char *right,
                  float share, bool chosen);

/* A bar behind a name and a value: a share of a whole. */
void ui_bar(uint32_t color, const char *name, int indent, float share, const char *format, ...)
    __attribute__((format(printf, 5, 6)));

/* A ground for columns, and what its upper edge stands for. */
struct ui_graph {
    float x, y, width, height;
};

struct ui_graph ui_graph_begin(float width, float height, const char *top);

/* A part of the n-th column of so many, from 0 below to 1 above. */
void ui_graph_column(const struct ui_graph *graph, int n, int count, float from, float to,
                     uint32_t color);

/* --- drawing on the picture, below all areas; or on a canvas, between its begin and end --- */

/* A part of an area, as wide as that, to be drawn on; and what the mouse does to it. */
struct ui_canvas {
    float x, y, width, height, mouse_x, mouse_y;
    bool hovered, clicked;
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

/* A text; align as below. */
void ui_draw_text(float x, float y, float align, enum ui_tone tone, const char *text);

/* A text beside the mouse, in this frame. */
void ui_tooltip(const char *text);

/* A text on a dark ground, and its width; align 0 = x is its left edge, 1 = its right one. */
void ui_draw_label(float x, float y, float align, const char *text);
float ui_label_width(const char *text);

#ifdef __cplusplus
}
#endif

#endif
