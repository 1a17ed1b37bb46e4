/* A list that is searched by what is typed, behind the C of ui.h. */
#include "viewer/window/look.hpp"

/* It lies above all areas but is not the active one: a field above it keeps the keyboard. */
void ui_veil(float window_width, float window_height) {
    ImGui::SetNextWindowPos(ImVec2(0, 0));
    ImGui::SetNextWindowSize(ImVec2(window_width, window_height));
    ImGui::PushStyleColor(ImGuiCol_WindowBg, IM_COL32(8, 9, 11, 150));
    ImGui::Begin("veil", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                     ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNav);
    ImGui::BringWindowToDisplayFront(ImGui::GetCurrentWindow());
    ImGui::End();
    ImGui::PopStyleColor();
}

bool ui_entry(const char *name, bool chosen, bool seeks) {
    if (chosen)
        ImGui::PushStyleColor(ImGuiCol_Text, accent);
    bool clicked = ImGui::Selectable(look_read(name), chosen);
    if (chosen)
        ImGui::PopStyleColor();
    look_mark(name);
    if (chosen && seeks)
        ImGui::SetScrollHereY(.5F);
    return clicked;
}

void ui_list_begin(const char *id) {
    ImGui::BeginChild(id, ImVec2(0, 0), false, ImGuiWindowFlags_NoNav);
}

void ui_list_end(void) {
    ImGui::EndChild();
}

namespace {

/* Only so that arrows up and down are this field's. */
int leave_arrows(ImGuiInputTextCallbackData *) {
    return 0;
}

ui_search pressed_key() {
    const struct {
        ImGuiKey key;
        ui_search search;
    } keys[] = {{ImGuiKey_UpArrow, UI_SEARCH_UP},
                {ImGuiKey_DownArrow, UI_SEARCH_DOWN},
                {ImGuiKey_PageUp, UI_SEARCH_PAGE_UP},
                {ImGuiKey_PageDown, UI_SEARCH_PAGE_DOWN}};
    for (const auto &entry : keys)
        if (imgui_is_pressed(entry.key, true))
            return entry.search;
    return UI_SEARCH_NOTHING;
}

/* A button or a name that is being pressed keeps the mouse. Nothing waits for long: a field that does not come is no
 * reason to take no more keys. */
void take_keys(ImGuiID field, bool has_keys) {
    static int frames;
    frames = has_keys ? 0 : frames + 1;
    if (has_keys && look.typed == field)
        look.typed = 0;
    if (has_keys || ImGui::IsAnyItemActive())
        return;
    ImGui::SetKeyboardFocusHere();
    if (frames < 4)
        look.typed = field;
}

} // namespace

/* What is typed while the field has not got the keyboard yet waits (ui_is_opening_field). */
ui_search ui_search_field(const char *id, char *text, size_t size, const char *hint) {
    ImGuiID own = ImGui::GetID(id);
    bool has_keys = ImGui::GetActiveID() == own, was_empty = !*text;
    take_keys(own, has_keys);
    ImGui::SetNextItemWidth(-1);
    look_read(text);
    bool entered = ImGui::InputTextWithHint(
        id, hint, text, size,
        ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CallbackHistory, leave_arrows);
    look_mark(hint);
    if (entered)
        return UI_SEARCH_ENTERED;
    if (has_keys && was_empty && imgui_is_pressed(ImGuiKey_Backspace, true))
        return UI_SEARCH_BACK;
    return ImGui::IsItemEdited() ? UI_SEARCH_EDITED : has_keys ? pressed_key() : UI_SEARCH_NOTHING;
}
