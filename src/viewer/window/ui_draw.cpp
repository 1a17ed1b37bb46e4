/* Drawing on the picture, behind the C of ui.h. */
#include "viewer/window/look.hpp"

static ImDrawList *canvas() {
    return look.on_canvas ? ImGui::GetWindowDrawList() : ImGui::GetBackgroundDrawList();
}

void ui_canvas_begin(const char *name, float height, struct ui_canvas *where) {
    ImVec2 at = ImGui::GetCursorScreenPos();
    float width = ImGui::GetContentRegionAvail().x;
    *where = {at.x, at.y, width, height};
    ImGui::Dummy(ImVec2(width, height));
    look_mark(name);
    look.on_canvas = true;
}

void ui_canvas_end(void) {
    look.on_canvas = false;
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

float ui_label_width(const char *text) {
    return ImGui::CalcTextSize(look_read(text)).x + 2 * units(.35F);
}

void ui_draw_label(float x, float y, float align, const char *text) {
    ImVec2 size = ImGui::CalcTextSize(look_read(text));
    float pad = units(.35F), left = x - align * (size.x + 2 * pad);
    canvas()->AddRectFilled(ImVec2(left, y), ImVec2(left + size.x + 2 * pad, y + size.y + pad),
                            see_through, units(.2F));
    canvas()->AddText(ImVec2(left + pad, y + pad / 2), text_color, text);
    look_note(left, y, {size.x + 2 * pad, size.y + pad}, text);
}

void ui_draw_text(float x, float y, float align, enum ui_tone tone, const char *text) {
    canvas()->AddText(ImVec2(x - align * ImGui::CalcTextSize(text).x, y), look_color(tone), text);
}
