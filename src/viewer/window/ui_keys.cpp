/* The keyboard in a panel, behind the C of ui.h: Tab enters it and goes on, Esc or a click leaves it. Only then do
 * arrows and Space mean its widgets; else they are the picture's. */
#include "viewer/window/look.hpp"

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
    ImGui::GetCurrentContext()->NavDisableHighlight = true;
    look.had_keys = true;
    look.has_keys = false;
}

/* All widgets lie below each other: Dear ImGui's own Tab goes to those alone into which one types. */
static void go_on(ImGuiIO &io) {
    if (io.WantTextInput)
        ImGui::ClearActiveID();
    io.KeysDown[io.KeyMap[io.KeyShift ? ImGuiKey_UpArrow : ImGuiKey_DownArrow]] = true;
}

void look_follow_keys(void) {
    ImGuiIO &io = ImGui::GetIO();
    int tab = io.KeyMap[ImGuiKey_Tab], escape = io.KeyMap[ImGuiKey_Escape];
    bool tabbed = io.KeysDown[tab] && !look.tab_before && !io.KeyCtrl && !io.KeyAlt;
    bool escaped = io.KeysDown[escape] && !look.escape_before;
    bool holds = io.KeysDown[tab] && look.tab_enters; /* the one that entered */
    bool is_open = ImGui::GetCurrentContext()->OpenPopupStack.Size > 0 || io.WantTextInput;
    look.tab_enters = holds;
    look.tab_before = io.KeysDown[tab];
    look.escape_before = io.KeysDown[escape];
    look.had_keys = false;
    if (look.has_keys && (!panel() || io.MouseDown[0] || (escaped && !is_open)))
        leave();
    else if (!look.has_keys && tabbed && !is_open && panel())
        enter(panel());
    else if (look.has_keys && io.KeysDown[tab] && !holds)
        go_on(io);
    if (look.has_keys)
        io.KeysDown[tab] = false;
}

/* NewFrame would forget it. */
void look_begin_keys(void) {
    ImGuiWindow *window = panel();
    if (look.begins_keys && window) {
        ImGui::NavInitWindow(window, true);
        ImGui::GetCurrentContext()->NavDisableHighlight = false;
    }
    look.begins_keys = false;
}

bool ui_is_entered(void) {
    const ImGuiIO &io = ImGui::GetIO();
    return !io.WantTextInput && !look.has_keys &&
           (ImGui::IsKeyPressed(io.KeyMap[ImGuiKey_Enter], false) ||
            ImGui::IsKeyPressed(io.KeyMap[ImGuiKey_KeyPadEnter], false));
}
