/* Direct light with convolution soft shadow maps [Dong 2011 ch. 5]. */
#include "base/memory.h"
#include "direct/prefiltered.h"
#include "passes/visibility/basis.h"
#include "shared/lookup.h"

#include <stdlib.h>

struct cssm_settings {
    int terms;
};

static const struct option table[] = {
    {"harmonics", 0, OPTION_INT, offsetof(struct cssm_settings, terms), 8, 1, 16,
     .help = "terms of the Fourier series, K"},
    {NULL},
};

static const struct settings_part own_part = {"cssm", "convolution soft shadow maps of lights",
                                              table, sizeof(struct cssm_settings)};

struct cssm {
    struct prefiltered prefiltered;
    struct basis_pass basis;
};

static void free_state(void *state) {
    struct cssm *cssm = state;
    if (cssm) {
        prefiltered_end(&cssm->prefiltered);
        basis_pass_free(&cssm->basis);
    }
    free(cssm);
}

static void show_bases(struct cssm *cssm) {
    struct direct_light_inputs *inputs = &cssm->prefiltered.shadow.inputs;
    const struct basis_maps *maps = &cssm->basis.maps;
    const struct pass_texture textures[] = {
        {UNIT_BASIS_COS, maps->cos.id},     {UNIT_BASIS_SIN, maps->sin.id},
        {UNIT_BASIS_Z_COS, maps->z_cos.id}, {UNIT_BASIS_Z_SIN, maps->z_sin.id},
        {UNIT_BASIS_Z, maps->z.id},
    };
    for (int i = 0; i < 5; i++)
        inputs->more[i + 1] = textures[i];
    inputs->block = (struct pass_block){.block = BLOCK_SERIES_RANGES, .buffer = &maps->ranges};
}

static bool init(void **state, const struct direct_desc *desc) {
    const struct cssm_settings *own = settings_of(desc->settings, &own_part);
    struct series_step step = series_step_of(own->terms);
    struct cssm *cssm = *state = mem_alloc(1, sizeof *cssm);
    char *defines = mem_printf("MAP_COUNT %d;BASIS_TERMS %d;BASIS_GROUPS %d;", desc->lights->maps,
                               own->terms, (own->terms + 3) / 4);
    bool ok = prefiltered_begin(&cssm->prefiltered, desc,
                                &(struct prefiltered_desc){.filter = FILTER_CSSM_WINDOW,
                                                           .search_parts = 8,
                                                           .shadow_parts = 8,
                                                           .defines = defines,
                                                           .shift = (float)step.zero,
                                                           .gain = (float)(1 / step.full)}) &&
              basis_pass_init(&cssm->basis,
                              &(struct basis_desc){.size = cssm->prefiltered.light_maps.maps.size,
                                                   .count = desc->lights->maps,
                                                   .terms = own->terms});
    free(defines);
    if (ok)
        show_bases(cssm);
    return ok;
}

static void render_lights(void *state, const struct frame *frame) {
    struct cssm *cssm = state;
    prefiltered_render_lights(&cssm->prefiltered, frame);
    basis_pass_render(&cssm->basis, frame, &cssm->prefiltered.light_maps.maps.depth);
}

static const struct settings_part *const parts[] = {&own_part, &prefilter_part, &shadow_part, NULL};

extern const struct direct_method cssm_direct;
const struct direct_method cssm_direct = {
    .name = "cssm",
    .help = "soft shadows from Fourier series of depth, filtered",
    .parts = parts,
    .init = init,
    .free = free_state,
    .resize = shadow_resize,
    .render_lights = render_lights,
    .render_view = shadow_render_view,
    .light = shadow_light,
    .specular = shadow_specular,
};
