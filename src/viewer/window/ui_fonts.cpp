/* The fonts of the viewer's texts. Letters beyond those that its own words need, as in the names of
 * files, are read when a text first has them: fonts of Chinese, Japanese and Korean have tens of
 * thousands. */
#include "viewer/window/look.hpp"

extern "C" {
#include "base/log.h"
}

#include <cstring>
#include <unistd.h>

namespace {

/* What our own words need. */
const ImWchar usual[] = {0x20,   0xff,   0x0394, 0x03c9, 0x2010, 0x2027, 0x2080, 0x208e,
                         0x2190, 0x21ff, 0x2212, 0x2212, 0x25a0, 0x25ff, 0};

/* Where the systems that we know keep them: the first that is there. */
const char *find(const char *const *files) {
    while (*files && access(*files, R_OK) != 0)
        files++;
    return *files;
}

const char *latin() {
    static const char *const files[] = {
        "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
        "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
        "/usr/share/fonts/TTF/DejaVuSans.ttf",
        "/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
        "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf",
        nullptr,
    };
    return find(files);
}

const char *east_asian() {
    static const char *const files[] = {
        "/usr/share/fonts/opentype/noto/NotoSansCJK-Regular.ttc",
        "/usr/share/fonts/google-noto-cjk/NotoSansCJK-Regular.ttc",
        "/usr/share/fonts/google-noto-sans-cjk-fonts/NotoSansCJK-Regular.ttc",
        "/usr/share/fonts/noto-cjk/NotoSansCJK-Regular.ttc",
        "/usr/share/fonts/truetype/wqy/wqy-microhei.ttc",
        "/usr/share/fonts/truetype/wqy/wqy-zenhei.ttc",
        "/usr/share/fonts/wenquanyi/wqy-microhei/wqy-microhei.ttc",
        "/usr/share/fonts/truetype/droid/DroidSansFallbackFull.ttf",
        "/usr/share/fonts/opentype/ipafont-gothic/ipag.ttf",
        "/usr/share/fonts/truetype/arphic/uming.ttc",
        "/usr/share/fonts/truetype/nanum/NanumGothic.ttf",
        nullptr,
    };
    return find(files);
}

/* A font of that size; what it lacks comes from the one of the letters of East Asia. */
ImFont *add(float size) {
    ImFontAtlas *fonts = ImGui::GetIO().Fonts;
    ImFontConfig config;
    config.OversampleH = 2;
    ImFont *font =
        fonts->AddFontFromFileTTF(latin(), size * look.scale, &config, look.letters.data());
    if (!look.has_more_letters || !east_asian())
        return font;
    config.MergeMode = true;
    fonts->AddFontFromFileTTF(east_asian(), size * look.scale, &config, look.letters.data());
    return font;
}

} // namespace

void look_load_fonts(void) {
    ImGui::GetIO().Fonts->Clear();
    ImVector<ImWchar> ranges;
    look.wanted.AddRanges(usual);
    look.wanted.BuildRanges(&ranges);
    look.letters.assign(ranges.begin(), ranges.end());
    look.lacks_letters = false;
    if (latin()) {
        look.normal = add(14);
        look.title = add(19);
    } else { /* ImGui's own small one */
        look.normal = look.title = ImGui::GetIO().Fonts->AddFontDefault();
    }
}

/* Those that no font has are asked for but once. */
const char *look_read(const char *text) {
    for (const char *at = text; *at;) {
        unsigned letter = 0;
        at += ImTextCharFromUtf8(&letter, at, at + strlen(at));
        if (letter < 0x100 || letter > IM_UNICODE_CODEPOINT_MAX || look.wanted.GetBit(letter))
            continue;
        look.wanted.SetBit(letter);
        look.has_more_letters = look.lacks_letters = true;
    }
    return text;
}

void look_reload_fonts(void) {
    imgui_reload_fonts(look_load_fonts);
}

/* From the radicals on, letters are East Asian, and emoji. */
static void note_missing() {
    static bool is_noted;
    bool found = false;
    for (unsigned letter = 0x2e80; letter < 0xff00 && !found; letter++)
        found = look.wanted.GetBit(letter);
    if (!found || is_noted || east_asian())
        return;
    is_noted = true;
    log_note("a name has East Asian letters, and no font here has them; Noto Sans CJK would");
}

void look_follow_letters(void) {
    if (look.lacks_letters) {
        look_reload_fonts();
        note_missing();
    }
}
