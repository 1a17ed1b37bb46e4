/* What the files of the bridge to Dear ImGui share. */
#ifndef VIEWER_WINDOW_LOOK_HPP
#define VIEWER_WINDOW_LOOK_HPP

#include "viewer/window/imgui_versions.hpp"
#include "viewer/window/ui.h"

extern "C" {
#include "viewer/window/window.h"
}

#include <string>
#include <vector>

/* The colours of the viewer. Only the accent is saturated: the picture is to be looked at. */
constexpr ImU32 ground = IM_COL32(24, 26, 31, 255), raised = IM_COL32(42, 46, 54, 255),
                raised_more = IM_COL32(56, 61, 72, 255), line = IM_COL32(54, 58, 68, 255),
                text_color = IM_COL32(222, 225, 230, 255), dim = IM_COL32(140, 147, 160, 255),
                accent = IM_COL32(240, 168, 72, 255), accent_dark = IM_COL32(178, 118, 40, 255),
                warning = IM_COL32(244, 200, 96, 255), failure = IM_COL32(250, 120, 104, 255),
                see_through = IM_COL32(16, 17, 20, 205);

extern struct look {
    ImFont *normal, *title;
    float scale;
    bool on_canvas; /* what is drawn lies on a canvas of an area */
    bool in_dialog; /* whose width follows its text, and not the other way */
    struct {
        ImVec2 at;
        double since;
    } rest;            /* of the mouse, on an item */
    std::string asked; /* the section to be opened; "": none */
    bool has_keys;     /* a panel has the keyboard */
    bool begins_keys;  /* from this frame on: at its first widget */
    bool had_keys;     /* until this frame's Esc, which is not to mean something else, too */
    bool tab_before, escape_before; /* were down in the frame before */
    bool tab_enters;                /* and has entered a panel with that */
    ImGuiID typed;    /* the slider whose value is to be typed from the next frame on */
    int typed_frames; /* for which that has been so */
    ImFontGlyphRangesBuilder wanted; /* letters that texts have had */
    std::vector<ImWchar> letters; /* that the fonts were asked for, as ranges; which live as long */
    bool has_more_letters;        /* than our own words need */
    bool lacks_letters;           /* and some that the fonts were not asked for */
    bool notes_places;
    std::string places;
} look;

inline float units(float of_line) {
    return of_line * imgui_font_size(look.normal);
}

ImU32 look_color(ui_tone tone);
void look_text(ImU32 color, const char *text);

/* Declares the text that the arguments after the format make. */
#define LOOK_FORMAT(text, size, format)                                                            \
    char text[size];                                                                               \
    va_list arguments;                                                                             \
    va_start(arguments, format);                                                                   \
    std::vsnprintf(text, sizeof text, format, arguments);                                          \
    va_end(arguments)

/* Reads the fonts with all letters wanted; and again, between frames, of another size, or where
 * some are lacking. */
void look_load_fonts(void);
void look_reload_fonts(void);
void look_follow_letters(void);

/* The text itself, whose letters the fonts will have in the next frame. */
const char *look_read(const char *text);

/* Gives mouse and keyboard to Dear ImGui before a frame begins, and the keyboard to the panel or
 * takes it away; and when the frame has begun: viewer/window/ui_keys.cpp. */
void look_take_input(const struct input *input);
void look_begin_keys(void);

/* A tooltip for the last item, where the mouse rests on it. */
void look_explain(const char *help);

/* Notes where something lies, or the last item, for ui_places. */
void look_note(float left, float top, ImVec2 size, const char *name);
void look_mark(const char *name);

#endif
