#include "base/phases.h"

#include "base/clock.h"
#include "base/text.h"

static _Thread_local double sums[PHASE_COUNT];

static const char *const names[PHASE_COUNT] = {
    [PHASE_SCENE] = "scene",       [PHASE_CONTEXT] = "OpenGL",    [PHASE_PROGRAMS] = "programs",
    [PHASE_SIMPLIFY] = "simplify", [PHASE_TREE] = "tree of rays", [PHASE_PICTURE] = "first picture",
};

void phase_add(enum phase phase, double since_ms) {
    sums[phase] += clock_ms() - since_ms;
}

char *phases_text(void) {
    struct text text = {0};
    for (int i = 0; i < PHASE_COUNT; i++)
        text_print(&text, "%s%s %.0f ms", i ? ", " : "", names[i], sums[i]);
    return text.data;
}
