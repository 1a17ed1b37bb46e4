/* Rows of a panel, buttons and lists, behind the C of ui.h. */
#include "viewer/window/look.hpp"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>

namespace {

/* A row: its name in the left column; the widget gets what is left of the arrow. */
void row_begin(const ui_row *row) {
    ImGui::PushID(row->scope ? row->scope : "");
    ImGui::PushID(row->name);
    ImGui::AlignTextToFramePadding();
    look_text(row->differs ? text_color : dim, row->name);
    look_explain(row->help);
    float left = units(8.6F), arrow = units(1.5F);
    ImGui::SameLine(left);
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - arrow);
}

ui_result row_end(const ui_row *row, bool changed) {
    look_explain(row->help);
    ui_result result = changed ? UI_CHANGED : UI_NOTHING;
    if (row->differs) {
        ImGui::SameLine(ImGui::GetContentRegionMax().x - units(1.3F));
        ImGui::PushStyleColor(ImGuiCol_Button, IM_COL32_BLACK_TRANS);
        ImGui::PushStyleColor(ImGuiCol_Text, dim);
        if (ImGui::Button("\xe2\x86\xba", ImVec2(units(1.3F), 0))) /* an arrow turning back */
            result = UI_RESET;
        ImGui::PopStyleColor(2);
        look_explain("back to the default");
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

/* --- rows --- */

/* A slider, and its value beside it, which a knob would cover. A value that is typed (after a click
 * on it, or two on the slider, or Ctrl and one) counts when Enter is pressed, not with
 * each digit. */
template <typename T>
static ui_result slider(const ui_row *row, ImGuiDataType type, T *value, T minimum, T maximum,
                        const char *format, ImGuiSliderFlags flags) {
    row_begin(row);
    if (is_wide(minimum, maximum) && !row->even)
        flags |= ImGuiSliderFlags_Logarithmic;
    ImGuiID id = ImGui::GetID("##");
    bool typed = ImGui::TempInputIsActive(id) || look.typed == id;
    float gap = units(.3F), beside = units(3.4F);
    if (look.typed == id)
        ImGui::SetKeyboardFocusHere();
    if (!typed) {
        ImGui::SetNextItemWidth(ImGui::CalcItemWidth() - beside - gap);
        ImGui::PushStyleColor(ImGuiCol_Text, IM_COL32_BLACK_TRANS);
    }
    T now = *value;
    bool changed = ImGui::SliderScalar("##", type, &now, &minimum, &maximum, format,
                                       flags | ImGuiSliderFlags_AlwaysClamp);
    look_mark(row->name);
    if (look.typed == id && ImGui::TempInputIsActive(id))
        look.typed = 0;
    bool goes_on = typed && !ImGui::IsItemDeactivated();
    bool is_twice_clicked = ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0);
    if (!typed) {
        ImGui::PopStyleColor();
        look_explain(row->help);
        char text[32];
        ImGui::DataTypeFormatString(text, sizeof text, type, value, format);
        ImGui::SameLine(0, gap);
        ImGui::TextUnformatted(row->least && *value == minimum ? row->least : text);
        if (ImGui::IsItemClicked() || is_twice_clicked)
            look.typed = id;
    }
    if (changed && !goes_on)
        *value = now;
    return row_end(row, changed && !goes_on);
}

ui_result ui_flag(const ui_row *row, bool *value) {
    row_begin(row);
    bool changed = ImGui::Checkbox("##", value);
    look_mark(row->name);
    return row_end(row, changed);
}

ui_result ui_int(const ui_row *row, int *value, int minimum, int maximum) {
    return slider(row, ImGuiDataType_S32, value, minimum, maximum, "%d", 0);
}

ui_result ui_float(const ui_row *row, float *value, float minimum, float maximum) {
    return slider(row, ImGuiDataType_Float, value, minimum, maximum, "%.4g",
                  ImGuiSliderFlags_NoRoundToFormat);
}

ui_result ui_drag(const ui_row *row, float *value, float minimum, float maximum, float step) {
    row_begin(row);
    bool changed =
        ImGui::DragFloat("##", value, step, minimum, maximum, "%.2f", ImGuiSliderFlags_AlwaysClamp);
    look_mark(row->name);
    return row_end(row, changed);
}

ui_result ui_choice(const ui_row *row, int *value, const char *const *names, int count) {
    row_begin(row);
    bool changed = false;
    bool open =
        ImGui::BeginCombo("##", *value >= 0 && *value < count ? look_read(names[*value]) : "",
                          ImGuiComboFlags_HeightLargest);
    look_mark(row->name);
    for (int i = 0; open && i < count; i++) {
        ImGui::PushID(i);
        ImGui::PushStyleColor(ImGuiCol_Text, i == *value ? accent : text_color);
        if (ImGui::Selectable(look_read(names[i]), i == *value)) {
            changed = i != *value;
            *value = i;
        }
        ImGui::PopStyleColor();
        look_mark(names[i]);
        ImGui::PopID();
    }
    if (open)
        ImGui::EndCombo();
    return row_end(row, changed);
}

ui_result ui_vector(const ui_row *row, float value[3], float step) {
    row_begin(row);
    bool changed = ImGui::DragFloat3("##", value, step, 0, 0, "%.3g");
    look_mark(row->name);
    return row_end(row, changed);
}

/* Shown as a monitor has it. */
ui_result ui_color(const ui_row *row, float value[3]) {
    float shown[3];
    for (int c = 0; c < 3; c++)
        shown[c] = std::pow(value[c], 1 / 2.2F);
    row_begin(row);
    bool changed = ImGui::ColorEdit3("##", shown, ImGuiColorEditFlags_PickerHueWheel);
    look_mark(row->name);
    for (int c = 0; c < 3 && changed; c++)
        value[c] = std::pow(shown[c], 2.2F);
    return row_end(row, changed);
}

bool ui_scrub(const char *id, float *value, float most) {
    ImGui::PushID(id);
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    bool changed = ImGui::SliderFloat("##", value, 0, most, "", ImGuiSliderFlags_AlwaysClamp);
    look_mark(id);
    ImGui::PopID();
    return changed;
}

ui_result ui_text_field(const ui_row *row, char *text, size_t size, const char *hint) {
    row_begin(row);
    look_read(text);
    bool entered =
        ImGui::InputTextWithHint("##", hint, text, size, ImGuiInputTextFlags_EnterReturnsTrue);
    look_mark(row->name);
    look_explain(*text ? text : row->help); /* a path has more letters than there is room for */
    return row_end(row, entered);
}

/* --- others --- */

bool ui_button(const char *name, const char *help) {
    bool clicked = ImGui::Button(name);
    look_mark(name);
    look_explain(help);
    return clicked;
}

bool ui_wide_button(const char *name, const char *help) {
    bool clicked = ImGui::Button(name, ImVec2(ImGui::GetContentRegionAvail().x, 0));
    look_mark(name);
    look_explain(help);
    return clicked;
}

/* What each of so many buttons has beside its name, where the names and their gaps fill a line. */
static float beside_names(const char *const *names, int count, float gap) {
    float left = ImGui::GetContentRegionAvail().x - gap * (float)(count - 1);
    for (int i = 0; i < count; i++)
        left -= ImGui::CalcTextSize(names[i], nullptr, true).x;
    return ImMax(left, 0.F) / (float)count;
}

bool ui_segments(const char *id, int *value, const char *const *names, int count) {
    return ui_explained_segments(id, value, names, nullptr, count);
}

bool ui_explained_segments(const char *id, int *value, const char *const *names,
                           const char *const *helps, int count) {
    bool changed = false;
    float gap = units(.1F), beside = beside_names(names, count, gap);
    ImVec2 padding = ImGui::GetStyle().FramePadding;
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                        ImVec2(ImMin(padding.x, beside / 2), padding.y));
    ImGui::PushID(id);
    for (int i = 0; i < count; i++) {
        if (i > 0)
            ImGui::SameLine(0, gap);
        bool on = *value == i;
        ImGui::PushStyleColor(ImGuiCol_Button, on ? accent_dark : raised);
        ImGui::PushStyleColor(ImGuiCol_ButtonHovered, on ? accent_dark : raised_more);
        float width = ImGui::CalcTextSize(names[i], nullptr, true).x + beside;
        if (ImGui::Button(names[i], ImVec2(width, 0)) && !on) {
            *value = i;
            changed = true;
        }
        ImGui::PopStyleColor(2);
        look_mark(names[i]);
        look_explain(helps ? helps[i] : nullptr);
    }
    ImGui::PopID();
    ImGui::PopStyleVar();
    return changed;
}

bool ui_list_item(uint32_t patch, const char *name, const char *middle, const char *right,
                  float share, bool chosen) {
    ImVec2 at = ImGui::GetCursorScreenPos();
    float width = ImGui::GetContentRegionAvail().x, height = ImGui::GetTextLineHeight();
    ImDrawList *list = ImGui::GetWindowDrawList();
    float size = units(.7F), left = units(1.1F);
    share = ImClamp(share, 0.F, 1.F);
    if (share > 0)
        list->AddRectFilled(ImVec2(at.x + left, at.y),
                            ImVec2(at.x + left + (width - left) * share, at.y + height),
                            IM_COL32(240, 168, 72, 50), units(.15F));
    list->AddRectFilled(ImVec2(at.x, at.y + (height - size) / 2),
                        ImVec2(at.x + size, at.y + (height + size) / 2), patch, units(.15F));
    const char *texts[] = {middle, right};
    float step = units(2.5F), beside = ImGui::CalcTextSize(right).x + units(.8F);
    float columns[] = {width - step * std::ceil(ImMax(beside, units(3.6F)) / step), width};
    float room = columns[0] - ImGui::CalcTextSize(middle).x - units(.4F) - left;
    ImGui::Indent(left);
    bool clicked = ImGui::Selectable(("##" + std::string(name)).c_str(), chosen);
    look_mark(name);
    ImGui::Unindent(left);
    std::string shown = look_read(name);
    shown.resize(std::min(shown.find("##"), shown.size()));
    list->PushClipRect(at, ImVec2(at.x + left + room, at.y + height), true);
    list->AddText(ImVec2(at.x + left, at.y), text_color, shown.c_str());
    list->PopClipRect();
    if (ImGui::CalcTextSize(shown.c_str()).x > room)
        look_explain(shown.c_str());
    for (int i = 0; i < 2; i++)
        list->AddText(
            ImVec2(at.x + columns[i] - ImGui::CalcTextSize(texts[i]).x - units(.2F), at.y),
            text_color, texts[i]);
    return clicked;
}

void ui_bar(uint32_t packed, const char *name, int indent, float share, const char *format, ...) {
    LOOK_FORMAT(text, 64, format);
    ImVec2 at = ImGui::GetCursorScreenPos();
    float width = ImGui::GetContentRegionAvail().x, height = ImGui::GetTextLineHeight();
    float left = units(.8F) * (float)indent;
    share = ImClamp(share, 0.F, 1.F);
    if (share > 0)
        ImGui::GetWindowDrawList()->AddRectFilled(
            ImVec2(at.x + left, at.y), ImVec2(at.x + left + (width - left) * share, at.y + height),
            packed, units(.15F));
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + left + units(.2F));
    ImGui::TextUnformatted(name);
    ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(text).x - units(.2F));
    ImGui::TextUnformatted(text);
}

ui_graph ui_graph_begin(float width, float height, const char *top) {
    ImVec2 at = ImGui::GetCursorScreenPos();
    float text = ImGui::GetTextLineHeight();
    ImDrawList *list = ImGui::GetWindowDrawList();
    list->AddRectFilled(at, ImVec2(at.x + width, at.y + text + height), IM_COL32(0, 0, 0, 90));
    list->AddText(ImVec2(at.x + units(.2F), at.y), dim, top);
    list->AddLine(ImVec2(at.x, at.y + text), ImVec2(at.x + width, at.y + text), line);
    ImGui::Dummy(ImVec2(width, text + height));
    return {at.x, at.y + text, width, height};
}

void ui_graph_column(const ui_graph *graph, int n, int count, float from, float to,
                     uint32_t packed) {
    float step = graph->width / (float)count, x = graph->x + step * (float)n;
    float bottom = graph->y + graph->height;
    ImGui::GetWindowDrawList()->AddRectFilled(
        ImVec2(x, bottom - graph->height * ImClamp(to, 0.F, 1.F)),
        ImVec2(x + step, bottom - graph->height * ImClamp(from, 0.F, 1.F)), packed);
}
