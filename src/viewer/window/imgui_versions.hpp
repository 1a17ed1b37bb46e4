/* Dear ImGui 1.86 to 1.92 behind one interface: keys and mouse became events in 1.87, the highlight
 * got another name in 1.91.4, textures of fonts follow by themselves from 1.92 on. */
#ifndef VIEWER_WINDOW_IMGUI_VERSIONS_HPP
#define VIEWER_WINDOW_IMGUI_VERSIONS_HPP

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>
#include <imgui_internal.h>

#if IMGUI_VERSION_NUM < 18700

#define ImGuiKey_KeypadEnter ImGuiKey_KeyPadEnter

inline void imgui_set_key(ImGuiKey key, bool down) {
    ImGuiIO &io = ImGui::GetIO();
    io.KeysDown[io.KeyMap[key]] = down;
}

inline void imgui_set_modifiers(bool control, bool shift, bool alt) {
    ImGuiIO &io = ImGui::GetIO();
    io.KeyCtrl = control;
    io.KeyShift = shift;
    io.KeyAlt = alt;
}

inline void imgui_set_mouse(ImVec2 at, const bool *held, int count, float wheel) {
    ImGuiIO &io = ImGui::GetIO();
    io.MousePos = at;
    io.MouseWheel = wheel;
    for (int i = 0; i < count; i++)
        io.MouseDown[i] = held[i];
}

inline bool imgui_is_pressed(ImGuiKey key, bool repeats) {
    return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key), repeats);
}

#else

inline void imgui_set_key(ImGuiKey key, bool down) {
    ImGui::GetIO().AddKeyEvent(key, down);
}

inline void imgui_set_modifiers(bool control, bool shift, bool alt) {
    imgui_set_key(ImGuiMod_Ctrl, control);
    imgui_set_key(ImGuiMod_Shift, shift);
    imgui_set_key(ImGuiMod_Alt, alt);
}

inline void imgui_set_mouse(ImVec2 at, const bool *held, int count, float wheel) {
    ImGuiIO &io = ImGui::GetIO();
    io.ConfigInputTrickleEventQueue = false; /* a turn holds only what has no order */
    io.AddMousePosEvent(at.x, at.y);
    io.AddMouseWheelEvent(0, wheel);
    for (int i = 0; i < count; i++)
        io.AddMouseButtonEvent(i, held[i]);
}

inline bool imgui_is_pressed(ImGuiKey key, bool repeats) {
    return ImGui::IsKeyPressed(key, repeats);
}

#endif

#if IMGUI_VERSION_NUM < 19140
inline void imgui_show_highlight(bool shown) {
    ImGui::GetCurrentContext()->NavDisableHighlight = !shown;
}
#else
inline void imgui_show_highlight(bool shown) {
    ImGui::GetCurrentContext()->NavCursorVisible = shown;
}
#endif

#if IMGUI_VERSION_NUM < 19200

inline float imgui_font_size(const ImFont *font) {
    return font->FontSize;
}

inline void imgui_push_font(ImFont *font) {
    ImGui::PushFont(font);
}

/* Between frames: loads fonts, and their texture. */
inline void imgui_reload_fonts(void (*load)(void)) {
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    load();
    ImGui_ImplOpenGL3_CreateFontsTexture();
}

#else

inline float imgui_font_size(const ImFont *font) {
    return font->LegacySize;
}

inline void imgui_push_font(ImFont *font) {
    ImGui::PushFont(font, font->LegacySize);
}

inline void imgui_reload_fonts(void (*load)(void)) {
    load();
}

#endif

#endif
