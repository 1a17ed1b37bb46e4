/* The keyboard in a panel, behind the C of ui.h: Tab enters it and goes on, Esc or a click leaves
 * it. Only then do arrows and Space mean its widgets; else they are the picture's. */
#include "viewer/window/look.hpp"

#include <algorithm>
#include <cfloat>

static ImGuiWindow *panel(void) {
    ImGuiWindow *window = ImGui::FindWindowByName("panel");
    return window && window->WasActive ? window : nullptr;
}

static void enter(ImGuiWindow *window) {
    ImGui::GetIO().ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    ImGui::FocusWindow(window);
    look.has_keys = look.begins_keys = look.tab_enters = true;
}

static void leave(void) {
    ImGui::GetIO().ConfigFlags &= ~ImGuiConfigFlags_NavEnableKeyboard;
    imgui_show_highlight(false);
    look.had_keys = true;
    look.has_keys = false;
}

/* All widgets lie below each other: Dear ImGui's own Tab goes to those alone into which
 * one types. */
static void go_on(bool shift, bool keys[WIDGET_KEY_COUNT]) {
    if (ImGui::GetIO().WantTextInput)
        ImGui::ClearActiveID();
    keys[shift ? WIDGET_KEY_UpArrow : WIDGET_KEY_DownArrow] = true;
}

static void follow_keys(const struct input *input, bool keys[WIDGET_KEY_COUNT]) {
    bool tab = keys[WIDGET_KEY_Tab];
    bool tabbed = tab && !look.tab_before && !input->control && !input->alt;
    bool escaped = keys[WIDGET_KEY_Escape] && !look.escape_before;
    bool holds = tab && look.tab_enters; /* the one that entered */
    bool is_open =
        ImGui::GetCurrentContext()->OpenPopupStack.Size > 0 || ImGui::GetIO().WantTextInput;
    look.tab_enters = holds;
    look.tab_before = tab;
    look.escape_before = keys[WIDGET_KEY_Escape];
    look.had_keys = false;
    if (look.has_keys && (!panel() || input->held[BUTTON_LEFT] || (escaped && !is_open)))
        leave();
    else if (!look.has_keys && tabbed && !is_open && panel())
        enter(panel());
    else if (look.has_keys && tab && !holds)
        go_on(input->shift, keys);
    if (look.has_keys)
        keys[WIDGET_KEY_Tab] = false;
}

static ImVec2 mouse_of(const struct input *input) {
    bool held = std::any_of(input->held, input->held + BUTTON_COUNT, [](bool is) { return is; });
    ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
    if ((!input->inside && !held) || scale.x <= 0 || scale.y <= 0)
        return ImVec2(-FLT_MAX, -FLT_MAX);
    return ImVec2((float)input->x / scale.x, (float)input->y / scale.y);
}

void look_take_input(const struct input *input) {
    bool keys[WIDGET_KEY_COUNT];
    std::copy_n(input->widget_keys, (int)WIDGET_KEY_COUNT, keys);
    follow_keys(input, keys);
    imgui_set_mouse(mouse_of(input), input->held, BUTTON_COUNT, (float)input->scroll);
    imgui_set_modifiers(input->control, input->shift, input->alt);
#define SET_KEY(name, code) imgui_set_key(ImGuiKey_##name, keys[WIDGET_KEY_##name]);
    WIDGET_KEYS(SET_KEY)
#undef SET_KEY
    for (int i = 0; i < input->text_count; i++)
        ImGui::GetIO().AddInputCharacter(input->text[i]);
}

/* NewFrame would forget it. */
void look_begin_keys(void) {
    ImGuiWindow *window = panel();
    if (look.begins_keys && window) {
        ImGui::NavInitWindow(window, true);
        imgui_show_highlight(true);
    }
    look.begins_keys = false;
}
