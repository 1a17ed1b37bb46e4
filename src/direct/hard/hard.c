/* Direct light with hard shadow maps [Dong 2009 §6].
 *
 * The lookup is that of other maps of depth (passes/visibility/lookup.glsl), filtered over the four
 * nearest texels, so that the shadow's edge is a texel wide and not stepped. */
#include "base/memory.h"
#include "direct/shadow.h"

static bool init(void **state, const struct direct_desc *desc) {
    struct shadow *shadow = *state = mem_alloc(1, sizeof *shadow);
    const char *defines = desc->lights->sized ? "" : "POINTS_ONLY;";
    return shadow_begin(shadow, desc,
                        &(struct direct_light_desc){.fragment = "passes/visibility/direct.frag",
                                                    .defines = defines});
}

static const struct settings_part *const parts[] = {&shadow_part, NULL};

extern const struct direct_method hard_direct;
const struct direct_method hard_direct = {
    .name = "hard",
    .help = "hard shadows, one shadow map per light",
    .parts = parts,
    .init = init,
    .free = shadow_free,
    .render_lights = shadow_render_lights,
    .render_view = shadow_render_view,
    SHADOW_METHOD,
};
