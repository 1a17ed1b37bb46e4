/* Dear ImGui behind the C of ui.h. Nothing here decides what the viewer does. */
#include "viewer/window/look.hpp"

extern "C" {
#include "base/error.h"
}

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <string>

struct look look;

namespace {

ImVec4 color(ImU32 packed) {
    return ImGui::ColorConvertU32ToFloat4(packed);
}

/* From its beginning: sizes that are not named here are scaled, too. */
void set_sizes(ImGuiStyle &style) {
    style = ImGuiStyle();
    style.WindowPadding = ImVec2(14, 12);
    style.FramePadding = ImVec2(7, 3);
    style.ItemSpacing = ImVec2(7, 5);
    style.ItemInnerSpacing = ImVec2(5, 4);
    style.ScrollbarSize = 11;
    style.GrabMinSize = 9;
    style.WindowBorderSize = 0;
    style.PopupBorderSize = 1;
    style.WindowRounding = style.FrameRounding = style.PopupRounding = 3;
    style.GrabRounding = style.ScrollbarRounding = 3;
    style.WindowMinSize = ImVec2(8, 8);
    style.ScaleAllSizes(look.scale);
}

void set_colors(ImGuiStyle &style) {
    const struct {
        int where;
        ImU32 what;
    } colors[] = {
        {ImGuiCol_Text, text_color},
        {ImGuiCol_TextDisabled, dim},
        {ImGuiCol_WindowBg, ground},
        {ImGuiCol_PopupBg, raised},
        {ImGuiCol_Border, line},
        {ImGuiCol_FrameBg, raised},
        {ImGuiCol_FrameBgHovered, raised_more},
        {ImGuiCol_FrameBgActive, raised_more},
        {ImGuiCol_ScrollbarBg, ground},
        {ImGuiCol_ScrollbarGrab, raised_more},
        {ImGuiCol_ScrollbarGrabHovered, dim},
        {ImGuiCol_ScrollbarGrabActive, dim},
        {ImGuiCol_CheckMark, accent},
        {ImGuiCol_SliderGrab, accent_dark},
        {ImGuiCol_SliderGrabActive, accent},
        {ImGuiCol_Button, raised},
        {ImGuiCol_ButtonHovered, raised_more},
        {ImGuiCol_ButtonActive, accent_dark},
        {ImGuiCol_Header, raised},
        {ImGuiCol_HeaderHovered, raised_more},
        {ImGuiCol_HeaderActive, raised_more},
        {ImGuiCol_Separator, line},
        {ImGuiCol_PlotLines, accent},
        {ImGuiCol_TextSelectedBg, accent_dark},
        {ImGuiCol_NavHighlight, accent},
    };
    for (const auto &entry : colors)
        style.Colors[entry.where] = color(entry.what);
}

} // namespace

ImU32 look_color(ui_tone tone) {
    switch (tone) {
    case UI_DIM:
        return dim;
    case UI_WARNING:
        return warning;
    case UI_ERROR:
        return failure;
    default:
        return text_color;
    }
}

void look_text(ImU32 color, const char *text) {
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    ImGui::TextUnformatted(text);
    ImGui::PopStyleColor();
}

/* Beside the panel where there is room: else it covers the rows below. */
static void place_tooltip(const char *text, float wrap) {
    const ImGuiWindow *window = ImGui::GetCurrentWindow()->RootWindow;
    const ImGuiStyle &style = ImGui::GetStyle();
    ImVec2 size = ImGui::CalcTextSize(text, nullptr, false, wrap);
    float height = size.y + 2 * style.WindowPadding.y;
    if (window->Pos.x < size.x + 2 * style.WindowPadding.x + units(.5F))
        return;
    float y = std::min(ImGui::GetItemRectMin().y, ImGui::GetIO().DisplaySize.y - height);
    ImGui::SetNextWindowPos(ImVec2(window->Pos.x - units(.3F), std::max(y, 0.F)), ImGuiCond_Always,
                            ImVec2(1, 0));
}

/* Once the mouse has rested for a while, and not while it holds something. */
void look_explain(const char *help) {
    if (!help || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled))
        return;
    double now = ImGui::GetTime();
    ImVec2 at = ImGui::GetItemRectMin();
    if (at.x != look.rest.at.x || at.y != look.rest.at.y || ImGui::IsAnyItemActive())
        look.rest = {at, now};
    if (now - look.rest.since < .5)
        return;
    std::string text = look_read(help); /* its lines are a terminal's */
    std::replace(text.begin(), text.end(), '\n', ' ');
    place_tooltip(text.c_str(), units(22));
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(units(22));
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

void look_note(float left, float top, ImVec2 size, const char *name) {
    char place[128];
    if (!look.notes_places)
        return;
    snprintf(place, sizeof place, "%.0f %.0f %.0f %.0f ", left, top, size.x, size.y);
    look.places.append(place).append(name).append("\n");
}

void look_mark(const char *name) {
    ImVec2 least = ImGui::GetItemRectMin(), most = ImGui::GetItemRectMax();
    ImVec2 middle((least.x + most.x) / 2, (least.y + most.y) / 2);
    if (ImGui::GetCurrentWindow()->ClipRect.Contains(middle))
        look_note(least.x, least.y, {most.x - least.x, most.y - least.y}, name);
}

bool ui_init(void *native_window, float scale) {
    look = {};
    look.scale = scale;
    ImGui::CreateContext();
    ImGuiIO &io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.ConfigWindowsMoveFromTitleBarOnly = true;
    look_load_fonts();
    set_sizes(ImGui::GetStyle());
    set_colors(ImGui::GetStyle());
    if (ImGui_ImplGlfw_InitForOpenGL(static_cast<GLFWwindow *>(native_window), false) &&
        ImGui_ImplOpenGL3_Init("#version 450 core"))
        return true;
    return error_set("the user interface cannot use this OpenGL");
}

void ui_free(void) {
    if (!ImGui::GetCurrentContext())
        return;
    look.places.clear();
    look.letters.clear();
    look.wanted.Clear();
    if (ImGui::GetIO().BackendRendererUserData)
        ImGui_ImplOpenGL3_Shutdown();
    if (ImGui::GetIO().BackendPlatformUserData)
        ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

/* The window has come to another monitor, or the user wants it so. */
static void follow_scale(float scale) {
    if (scale == look.scale)
        return;
    look.scale = scale;
    set_sizes(ImGui::GetStyle());
    set_colors(ImGui::GetStyle());
    look_reload_fonts();
}

void ui_frame_begin(const struct input *input) {
    look.places.clear();
    follow_scale(input->scale);
    look_follow_letters();
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    look_take_input(input); /* in place of what the backend has polled, which knows no order */
    ImGui::NewFrame();
    look_begin_keys();
    /* A row that is not there any more opens nothing. */
    look.typed_frames = look.typed ? look.typed_frames + 1 : 0;
    if (look.typed_frames > 4)
        look.typed = 0;
}

void ui_frame_end(void) {
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void ui_note_places(void) {
    look.notes_places = true;
}

const char *ui_places(void) {
    return look.places.c_str();
}

bool ui_wants_mouse(void) {
    return ImGui::GetIO().WantCaptureMouse;
}

bool ui_wants_keys(void) {
    return ImGui::GetIO().WantTextInput || look.has_keys || look.had_keys;
}

bool ui_is_opening_field(void) {
    return look.typed != 0;
}

bool ui_close_popup(void) {
    ImGuiContext &context = *ImGui::GetCurrentContext();
    bool open = context.OpenPopupStack.Size > 0;
    if (open)
        ImGui::ClosePopupToLevel(0, true);
    return open;
}

void ui_show_cursor(ui_cursor cursor) {
    ImGui::SetMouseCursor(cursor == UI_CURSOR_HAND ? ImGuiMouseCursor_Hand
                                                   : ImGuiMouseCursor_ResizeEW);
}

float ui_line_height(void) {
    return imgui_font_size(look.normal);
}

/* --- areas --- */

void ui_area_begin(const char *id, ui_area kind, float x, float y, float width, float height) {
    ImGuiWindowFlags flags =
        ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings;
    if (kind == UI_PANEL || kind == UI_PAGE)
        flags &= ~ImGuiWindowFlags_NoScrollbar;
    else if (kind != UI_BAR)
        flags |= ImGuiWindowFlags_AlwaysAutoResize;
    bool see = kind == UI_OVERLAY || kind == UI_NOTE;
    bool square = kind == UI_PANEL || kind == UI_BAR;
    look.in_dialog = kind == UI_DIALOG;
    if (see)
        flags |= ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoFocusOnAppearing |
                 ImGuiWindowFlags_NoBringToFrontOnFocus;
    ImVec2 pivot = kind == UI_DIALOG ? ImVec2(.5F, .5F) : ImVec2(0, kind == UI_NOTE ? 1 : 0);
    ImGui::SetNextWindowPos(ImVec2(x, y), ImGuiCond_Always, pivot);
    if (kind != UI_DIALOG)
        ImGui::SetNextWindowSize(ImVec2(width, height));
    ImGui::PushStyleColor(ImGuiCol_WindowBg, see ? see_through : ground);
    if (kind == UI_PAGE)
        ImGui::SetNextWindowFocus();
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, kind == UI_PAGE ? 1.F : 0.F);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, square ? 0 : units(.4F));
    ImGui::Begin(id, nullptr, flags);
    if (kind == UI_NOTE) /* it would lie below areas that come after it */
        ImGui::BringWindowToDisplayFront(ImGui::GetCurrentWindow());
    ImGui::PopStyleVar(2);
    ImGui::PopStyleColor();
}

void ui_page_begin(const char *id, float window_width, float window_height, float lines_wide,
                   float lines_high) {
    float width = std::min(units(lines_wide), window_width - units(2));
    float height = std::min(units(lines_high), window_height - units(2));
    ui_area_begin(id, UI_PAGE, (window_width - width) / 2, (window_height - height) / 2, width,
                  height);
}

void ui_area_end(void) {
    ImGui::End();
}

void ui_open_section(const char *title) {
    look.asked = title;
}

void ui_show_here(void) {
    ImGui::SetScrollHereY(0);
}

bool ui_section(const char *title, bool open_at_first) {
    bool asked = look.asked == title;
    ImGui::Dummy(ImVec2(0, units(.1F)));
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(units(.4F), units(.3F)));
    if (asked)
        ImGui::SetNextItemOpen(true);
    bool open = ImGui::CollapsingHeader(title, open_at_first ? ImGuiTreeNodeFlags_DefaultOpen : 0);
    look_mark(title);
    ImGui::PopStyleVar();
    if (asked)
        look.asked.clear();
    return open;
}

void ui_heading(const char *title) {
    ImGui::Dummy(ImVec2(0, units(.2F)));
    ui_text(UI_NORMAL, "%s", title);
    ImGui::Separator();
}

void ui_separator(void) {
    ImGui::Dummy(ImVec2(0, units(.1F)));
    ImGui::Separator();
    ImGui::Dummy(ImVec2(0, units(.1F)));
}

void ui_space(void) {
    ImGui::Dummy(ImVec2(0, units(.3F)));
}

void ui_same_line(void) {
    ImGui::SameLine();
}

void ui_disabled_begin(bool disabled) {
    ImGui::BeginDisabled(disabled);
}

void ui_disabled_end(void) {
    ImGui::EndDisabled();
}

/* --- text --- */

void ui_text(ui_tone tone, const char *format, ...) {
    LOOK_FORMAT(text, 2048, format);
    ImGui::PushStyleColor(ImGuiCol_Text, look_color(tone));
    imgui_push_font(tone == UI_TITLE ? look.title : look.normal);
    ImGui::PushTextWrapPos(look.in_dialog ? units(40) : 0);
    ImGui::TextUnformatted(look_read(text));
    ImGui::PopTextWrapPos();
    ImGui::PopFont();
    ImGui::PopStyleColor();
}

void ui_value(const char *name, const char *format, ...) {
    LOOK_FORMAT(text, 256, format);
    look_text(dim, look_read(name));
    float right = ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(look_read(text)).x;
    ImGui::SameLine(right > units(5) ? right : units(5));
    ImGui::TextUnformatted(text);
}

void ui_fact(const char *name, const char *help, const char *format, ...) {
    LOOK_FORMAT(text, 256, format);
    ImVec2 at = ImGui::GetCursorScreenPos();
    ImRect row(at,
               ImVec2(at.x + ImGui::GetContentRegionAvail().x, at.y + ImGui::GetTextLineHeight()));
    ui_value(name, "%s", text);
    ImGui::SetLastItemData(0, ImGuiItemFlags_None,
                           ImGui::IsMouseHoveringRect(row.Min, row.Max)
                               ? ImGuiItemStatusFlags_HoveredRect
                               : ImGuiItemStatusFlags_None,
                           row);
    look_mark((std::string(name) + " " + text).c_str());
    look_explain(help);
}

void ui_numbers(const char *name, const float values[3]) {
    float right = ImGui::GetContentRegionMax().x, column = units(4.3F);
    std::string all = name;
    look_text(dim, name);
    for (int c = 0; c < 3; c++) {
        char text[32];
        double value = (double)values[c], size = std::fabs(value);
        const char *format = size > 0 && size < 1e-3 ? "%.5f"
                             : size < 10             ? "%.4f"
                             : size < 100            ? "%.3f"
                                                     : "%.1f";
        std::snprintf(text, sizeof text, format, value);
        ImGui::SameLine(right - column * (float)(2 - c) - ImGui::CalcTextSize(text).x);
        ImGui::TextUnformatted(text);
        all = all + " " + text;
    }
    look_mark(all.c_str());
}

void ui_text_right(const char *format, ...) {
    LOOK_FORMAT(text, 256, format);
    float right = ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(text).x;
    ImGui::SetCursorPosX(std::max(right, ImGui::GetCursorPosX()));
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(text);
}

void ui_columns_begin(const char *id) {
    bool is_narrow = ImGui::GetContentRegionAvail().x < units(56);
    ImGui::BeginTable(id, is_narrow ? 1 : 2);
    ImGui::TableNextColumn();
}

void ui_columns_next(void) {
    ImGui::TableNextColumn();
}

void ui_columns_end(void) {
    ImGui::EndTable();
}

void ui_definition(const char *term, const char *meaning) {
    float left = ImGui::GetCursorPosX();
    ImGui::TextUnformatted(term);
    ImGui::SameLine();
    ImGui::SetCursorPosX(left + units(9));
    ImGui::PushStyleColor(ImGuiCol_Text, dim);
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(meaning);
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
}
