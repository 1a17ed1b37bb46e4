/* Dear ImGui behind the C of ui.h. Nothing here decides what the viewer does. */
#include "viewer/window/ui.h"

extern "C" {
#include "base/error.h"
}

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <string>
#include <unistd.h>

namespace {

/* The colours of the viewer. Only the accent is saturated: the picture is to be looked at. */
constexpr ImU32 ground = IM_COL32(24, 26, 31, 255), raised = IM_COL32(42, 46, 54, 255),
                raised_more = IM_COL32(56, 61, 72, 255), line = IM_COL32(54, 58, 68, 255),
                text_color = IM_COL32(222, 225, 230, 255), dim = IM_COL32(140, 147, 160, 255),
                accent = IM_COL32(240, 168, 72, 255), accent_dark = IM_COL32(178, 118, 40, 255),
                warning = IM_COL32(244, 200, 96, 255), failure = IM_COL32(250, 120, 104, 255),
                see_through = IM_COL32(16, 17, 20, 205);

struct {
    ImFont *normal, *title;
    float scale;
    bool in_dialog; /* whose width follows its text, and not the other way */
} look;

float units(float of_line) {
    return of_line * look.normal->FontSize;
}

ImVec4 color(ImU32 packed) {
    return ImGui::ColorConvertU32ToFloat4(packed);
}

/* Fonts where the systems that we know keep them; without any, ImGui's own small one. */
void load_fonts() {
    static const char *const files[] = {
        "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
        "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
        "/usr/share/fonts/TTF/DejaVuSans.ttf",
        "/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
        "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf",
    };
    static const ImWchar ranges[] = {0x20,   0xff,   0x0394, 0x03c9, 0x2010, 0x2027, 0x2080, 0x208e,
                                     0x2190, 0x21ff, 0x2212, 0x2212, 0x25a0, 0x25ff, 0};
    ImGuiIO &io = ImGui::GetIO();
    ImFontConfig config;
    config.OversampleH = 2;
    for (const char *file : files)
        if (!look.normal && access(file, R_OK) == 0) {
            look.normal = io.Fonts->AddFontFromFileTTF(file, 14 * look.scale, &config, ranges);
            look.title = io.Fonts->AddFontFromFileTTF(file, 19 * look.scale, &config, ranges);
        }
    if (!look.normal)
        look.normal = look.title = io.Fonts->AddFontDefault();
}

void set_sizes(ImGuiStyle &style) {
    style.WindowPadding = ImVec2(14, 12);
    style.FramePadding = ImVec2(7, 3);
    style.ItemSpacing = ImVec2(7, 5);
    style.ItemInnerSpacing = ImVec2(5, 4);
    style.ScrollbarSize = 11;
    style.GrabMinSize = 9;
    style.WindowBorderSize = style.PopupBorderSize = 0;
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
    };
    for (const auto &entry : colors)
        style.Colors[entry.where] = color(entry.what);
}

ImU32 color_of(ui_tone tone) {
    switch (tone) {
    case UI_DIM:
        return dim;
    case UI_ACCENT:
        return accent;
    case UI_WARNING:
        return warning;
    case UI_ERROR:
        return failure;
    default:
        return text_color;
    }
}

void explain(const char *help) {
    if (!help || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled))
        return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(units(22));
    std::string text = help; /* its lines are a terminal's */
    std::replace(text.begin(), text.end(), '\n', ' ');
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

/* A row: its name in the left column; the widget gets what is left of the arrow. */
void row_begin(const ui_row *row) {
    ImGui::PushID(row->scope ? row->scope : "");
    ImGui::PushID(row->name);
    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text, row->differs ? text_color : dim);
    ImGui::TextUnformatted(row->name);
    ImGui::PopStyleColor();
    explain(row->help);
    float left = units(8.6F), arrow = units(1.5F);
    ImGui::SameLine(left);
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - arrow);
}

ui_result row_end(const ui_row *row, bool changed) {
    explain(row->help);
    ui_result result = changed ? UI_CHANGED : UI_NOTHING;
    if (row->differs) {
        ImGui::SameLine(ImGui::GetContentRegionMax().x - units(1.3F));
        ImGui::PushStyleColor(ImGuiCol_Button, IM_COL32_BLACK_TRANS);
        ImGui::PushStyleColor(ImGuiCol_Text, dim);
        if (ImGui::Button("\xe2\x86\xba", ImVec2(units(1.3F), 0))) /* an arrow turning back */
            result = UI_RESET;
        ImGui::PopStyleColor(2);
        explain("back to the default");
    }
    ImGui::PopID();
    ImGui::PopID();
    return result;
}

/* Ranges over many powers of ten move evenly in the logarithm. */
bool is_wide(double minimum, double maximum) {
    return minimum >= 0 && maximum > 200 * (minimum > 1e-3 ? minimum : 1e-3);
}

} // namespace

bool ui_init(void *native_window, float scale) {
    look = {nullptr, nullptr, scale, false};
    ImGui::CreateContext();
    ImGuiIO &io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.ConfigWindowsMoveFromTitleBarOnly = true;
    load_fonts();
    set_sizes(ImGui::GetStyle());
    set_colors(ImGui::GetStyle());
    if (ImGui_ImplGlfw_InitForOpenGL(static_cast<GLFWwindow *>(native_window), true) &&
        ImGui_ImplOpenGL3_Init("#version 450 core"))
        return true;
    return error_set("the user interface cannot use this OpenGL");
}

void ui_free(void) {
    if (!ImGui::GetCurrentContext())
        return;
    if (ImGui::GetIO().BackendRendererUserData)
        ImGui_ImplOpenGL3_Shutdown();
    if (ImGui::GetIO().BackendPlatformUserData)
        ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

void ui_frame_begin(const int *taps, int tap_count) {
    ImGuiIO &io = ImGui::GetIO();
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    for (int i = 0; i < tap_count; i++)
        io.KeysDown[taps[i]] = true;
    ImGui::NewFrame();
    for (int i = 0; i < tap_count; i++)
        io.KeysDown[taps[i]] = false;
}

void ui_frame_end(void) {
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

bool ui_wants_mouse(void) {
    return ImGui::GetIO().WantCaptureMouse;
}

bool ui_wants_keys(void) {
    return ImGui::GetIO().WantTextInput;
}

bool ui_close_popup(void) {
    ImGuiContext &context = *ImGui::GetCurrentContext();
    bool open = context.OpenPopupStack.Size > 0;
    if (open)
        ImGui::ClosePopupToLevel(0, true);
    return open;
}

float ui_line_height(void) {
    return look.normal->FontSize;
}

/* --- areas --- */

void ui_area_begin(const char *id, ui_area kind, float x, float y, float width, float height) {
    ImGuiWindowFlags flags =
        ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings;
    if (kind == UI_PANEL)
        flags &= ~ImGuiWindowFlags_NoScrollbar;
    else
        flags |= ImGuiWindowFlags_AlwaysAutoResize;
    bool see = kind == UI_OVERLAY || kind == UI_NOTE;
    look.in_dialog = kind == UI_DIALOG;
    if (see)
        flags |= ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoFocusOnAppearing |
                 ImGuiWindowFlags_NoBringToFrontOnFocus;
    ImVec2 pivot = kind == UI_DIALOG ? ImVec2(.5F, .5F) : ImVec2(0, kind == UI_NOTE ? 1 : 0);
    ImGui::SetNextWindowPos(ImVec2(x, y), ImGuiCond_Always, pivot);
    if (kind != UI_DIALOG)
        ImGui::SetNextWindowSize(ImVec2(width, height));
    ImGui::PushStyleColor(ImGuiCol_WindowBg, see ? see_through : ground);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, kind == UI_PANEL ? 0 : units(.4F));
    ImGui::Begin(id, nullptr, flags);
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
}

void ui_area_end(void) {
    ImGui::End();
}

bool ui_section(const char *title, bool open_at_first) {
    ImGui::Dummy(ImVec2(0, units(.1F)));
    ImGui::PushStyleColor(ImGuiCol_Text, accent);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(units(.4F), units(.3F)));
    bool open = ImGui::CollapsingHeader(title, open_at_first ? ImGuiTreeNodeFlags_DefaultOpen : 0);
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
    return open;
}

void ui_heading(const char *title) {
    ImGui::Dummy(ImVec2(0, units(.2F)));
    ui_text(UI_ACCENT, "%s", title);
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
    char text[2048];
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    ImGui::PushStyleColor(ImGuiCol_Text, color_of(tone));
    ImGui::PushFont(tone == UI_TITLE ? look.title : look.normal);
    ImGui::PushTextWrapPos(look.in_dialog ? units(40) : 0);
    ImGui::TextUnformatted(text);
    ImGui::PopTextWrapPos();
    ImGui::PopFont();
    ImGui::PopStyleColor();
}

void ui_value(const char *name, const char *format, ...) {
    char text[256];
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    ImGui::PushStyleColor(ImGuiCol_Text, dim);
    ImGui::TextUnformatted(name);
    ImGui::PopStyleColor();
    float right = ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(text).x;
    ImGui::SameLine(right > units(5) ? right : units(5));
    ImGui::TextUnformatted(text);
}

void ui_definition(const char *term, const char *meaning) {
    ImGui::PushStyleColor(ImGuiCol_Text, accent);
    ImGui::TextUnformatted(term);
    ImGui::PopStyleColor();
    ImGui::SameLine(units(16));
    ImGui::TextUnformatted(meaning);
}

/* --- rows --- */

/* A slider, and its value beside it, which a knob would cover. A value that is typed (Ctrl and a click)
 * counts when Enter is pressed, not with each digit. */
template <typename T>
static ui_result slider(const ui_row *row, ImGuiDataType type, T *value, T minimum, T maximum,
                        const char *format, ImGuiSliderFlags flags) {
    row_begin(row);
    if (is_wide(minimum, maximum) && !row->even)
        flags |= ImGuiSliderFlags_Logarithmic;
    bool typed = ImGui::TempInputIsActive(ImGui::GetID("##"));
    float gap = units(.3F), beside = units(3.4F);
    if (!typed) {
        ImGui::SetNextItemWidth(ImGui::CalcItemWidth() - beside - gap);
        ImGui::PushStyleColor(ImGuiCol_Text, IM_COL32_BLACK_TRANS);
    }
    T now = *value;
    bool changed = ImGui::SliderScalar("##", type, &now, &minimum, &maximum, format,
                                       flags | ImGuiSliderFlags_AlwaysClamp);
    bool goes_on = typed && !ImGui::IsItemDeactivated();
    if (!typed) {
        ImGui::PopStyleColor();
        explain(row->help);
        char text[32];
        ImGui::DataTypeFormatString(text, sizeof text, type, value, format);
        ImGui::SameLine(0, gap);
        ImGui::TextUnformatted(row->least && *value == minimum ? row->least : text);
    }
    if (changed && !goes_on)
        *value = now;
    return row_end(row, changed && !goes_on);
}

ui_result ui_flag(const ui_row *row, bool *value) {
    row_begin(row);
    return row_end(row, ImGui::Checkbox("##", value));
}

ui_result ui_int(const ui_row *row, int *value, int minimum, int maximum) {
    return slider(row, ImGuiDataType_S32, value, minimum, maximum, "%d", 0);
}

ui_result ui_float(const ui_row *row, float *value, float minimum, float maximum) {
    return slider(row, ImGuiDataType_Float, value, minimum, maximum, "%.4g",
                  ImGuiSliderFlags_NoRoundToFormat);
}

ui_result ui_choice(const ui_row *row, int *value, const char *const *names, int count) {
    row_begin(row);
    return row_end(row, ImGui::Combo("##", value, names, count));
}

ui_result ui_vector(const ui_row *row, float value[3], float step) {
    row_begin(row);
    return row_end(row, ImGui::DragFloat3("##", value, step, 0, 0, "%.3g"));
}

ui_result ui_text_field(const ui_row *row, char *text, size_t size, const char *hint) {
    row_begin(row);
    return row_end(row, ImGui::InputTextWithHint("##", hint, text, size,
                                                 ImGuiInputTextFlags_EnterReturnsTrue));
}

/* --- others --- */

bool ui_button(const char *name, const char *help) {
    bool clicked = ImGui::Button(name);
    explain(help);
    return clicked;
}

bool ui_wide_button(const char *name, const char *help) {
    bool clicked = ImGui::Button(name, ImVec2(ImGui::GetContentRegionAvail().x, 0));
    explain(help);
    return clicked;
}

bool ui_segments(const char *id, int *value, const char *const *names, int count) {
    bool changed = false;
    float gap = units(.1F);
    float width = (ImGui::GetContentRegionAvail().x - gap * (float)(count - 1)) / (float)count;
    ImGui::PushID(id);
    for (int i = 0; i < count; i++) {
        if (i > 0)
            ImGui::SameLine(0, gap);
        bool on = *value == i;
        ImGui::PushStyleColor(ImGuiCol_Button, on ? accent_dark : raised);
        ImGui::PushStyleColor(ImGuiCol_ButtonHovered, on ? accent_dark : raised_more);
        if (ImGui::Button(names[i], ImVec2(width, 0)) && !on) {
            *value = i;
            changed = true;
        }
        ImGui::PopStyleColor(2);
    }
    ImGui::PopID();
    return changed;
}

bool ui_list_item(uint32_t patch, const char *name, const char *middle, const char *right,
                  float share, bool chosen) {
    ImVec2 at = ImGui::GetCursorScreenPos();
    float width = ImGui::GetContentRegionAvail().x, height = ImGui::GetTextLineHeight();
    ImDrawList *list = ImGui::GetWindowDrawList();
    float size = units(.7F), left = units(1.1F);
    share = ImClamp(share, 0.F, 1.F);
    list->AddRectFilled(ImVec2(at.x + left, at.y),
                        ImVec2(at.x + left + (width - left) * share, at.y + height),
                        IM_COL32(240, 168, 72, 50), units(.15F));
    list->AddRectFilled(ImVec2(at.x, at.y + (height - size) / 2),
                        ImVec2(at.x + size, at.y + (height + size) / 2), patch, units(.15F));
    ImGui::Indent(left);
    bool clicked = ImGui::Selectable(name, chosen);
    ImGui::Unindent(left);
    float columns[] = {.55F * width, width};
    const char *texts[] = {middle, right};
    for (int i = 0; i < 2; i++)
        list->AddText(
            ImVec2(at.x + columns[i] - ImGui::CalcTextSize(texts[i]).x - units(.2F), at.y),
            text_color, texts[i]);
    return clicked;
}

void ui_bar(const char *name, int indent, float share, const char *format, ...) {
    char text[64];
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    ImVec2 at = ImGui::GetCursorScreenPos();
    float width = ImGui::GetContentRegionAvail().x, height = ImGui::GetTextLineHeight();
    float left = units(.8F) * (float)indent;
    share = ImClamp(share, 0.F, 1.F);
    ImGui::GetWindowDrawList()->AddRectFilled(
        ImVec2(at.x + left, at.y), ImVec2(at.x + left + (width - left) * share, at.y + height),
        indent ? IM_COL32(240, 168, 72, 45) : IM_COL32(240, 168, 72, 80), units(.15F));
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + left + units(.2F));
    ImGui::TextUnformatted(name);
    ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(text).x - units(.2F));
    ImGui::TextUnformatted(text);
}

void ui_plot(const float *values, int count, float top, float width, float height) {
    ImGui::PushStyleColor(ImGuiCol_FrameBg, IM_COL32(0, 0, 0, 90));
    ImGui::PlotLines("##plot", values, count, 0, nullptr, 0, top, ImVec2(width, height));
    ImGui::PopStyleColor();
}

/* --- drawing on the picture --- */

static ImDrawList *canvas() {
    return ImGui::GetBackgroundDrawList();
}

void ui_draw_clip(float x, float y, float width, float height) {
    canvas()->PushClipRect(ImVec2(x, y), ImVec2(x + width, y + height));
}

void ui_draw_unclip(void) {
    canvas()->PopClipRect();
}

void ui_draw_line(float x0, float y0, float x1, float y1, uint32_t packed, float thickness) {
    canvas()->AddLine(ImVec2(x0, y0), ImVec2(x1, y1), packed, thickness * look.scale);
}

void ui_draw_disc(float x, float y, float radius, uint32_t packed) {
    canvas()->AddCircleFilled(ImVec2(x, y), radius * look.scale, packed);
}

void ui_draw_ring(float x, float y, float radius, uint32_t packed, float thickness) {
    canvas()->AddCircle(ImVec2(x, y), radius * look.scale, packed, 0, thickness * look.scale);
}

void ui_draw_rectangle(float x, float y, float width, float height, uint32_t packed) {
    canvas()->AddRectFilled(ImVec2(x, y), ImVec2(x + width, y + height), packed);
}

void ui_draw_label(float x, float y, float align, const char *text) {
    ImVec2 size = ImGui::CalcTextSize(text);
    float pad = units(.35F), left = x - align * (size.x + 2 * pad);
    canvas()->AddRectFilled(ImVec2(left, y), ImVec2(left + size.x + 2 * pad, y + size.y + pad),
                            see_through, units(.2F));
    canvas()->AddText(ImVec2(left + pad, y + pad / 2), text_color, text);
}
