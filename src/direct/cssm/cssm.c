/* Direct light with convolution soft shadow maps [Dong 2011 ch. 5]. */
#include "base/memory.h"
#include "direct/prefiltered.h"
#include "passes/visibility/basis.h"
#include "passes/visibility/sums.h"
#include "shared/maps.h"

enum { PREFILTER_MIP, PREFILTER_SAT };

struct cssm_settings {
    int terms, prefilter;
};

static const char *const prefilters[] = {"mip", "sat", NULL};

static const struct option table[] = {
    {"harmonics", 0, OPTION_INT, offsetof(struct cssm_settings, terms), 8, 1, 16,
     .label = "Fourier terms",
     .help = "terms of the Fourier series, K; raise against light at contacts"},
    {"prefilter", 0, OPTION_CHOICE, offsetof(struct cssm_settings, prefilter), PREFILTER_MIP,
     .label = "filter", .choices = prefilters,
     .help = "filter of the maps: MIP maps, or summed area tables, which\n"
             "have exact boxes and take 16 bytes per texel and term"},
    {NULL},
};

static const struct settings_part own_part = {"cssm", "convolution soft shadow maps of lights",
                                              table, sizeof(struct cssm_settings)};

struct cssm {
    struct prefiltered prefiltered;
    struct basis_pass basis;
    struct sums_pass sums; /* in place of the bases' MIP maps */
};

static void free_state(void *state) {
    struct cssm *cssm = state;
    if (cssm) {
        prefiltered_end(&cssm->prefiltered);
        basis_pass_free(&cssm->basis);
        sums_pass_free(&cssm->sums);
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
    if (cssm->sums.maps.count)
        inputs->more[1] = (struct pass_texture){UNIT_SUMS, cssm->sums.maps.sums.id};
    for (int i = 0; i < 5 && !cssm->sums.maps.count; i++)
        inputs->more[i + 1] = textures[i];
    inputs->block = (struct pass_block){.block = BLOCK_SERIES_RANGES, .buffer = &maps->ranges};
}

static bool init_bases(struct cssm *cssm, const struct cssm_settings *own, int maps) {
    bool sums = own->prefilter == PREFILTER_SAT;
    int size = cssm->prefiltered.light_maps.maps.size;
    return basis_pass_init(&cssm->basis, &(struct basis_desc){.size = size,
                                                              .count = maps,
                                                              .terms = own->terms,
                                                              .ranges_alone = sums}) &&
           (!sums ||
            sums_pass_init(&cssm->sums,
                           &(struct sums_desc){.size = size, .count = maps, .terms = own->terms}));
}

static bool init(void **state, const struct direct_desc *desc) {
    const struct cssm_settings *own = settings_of(struct cssm_settings, desc->settings, &own_part);
    struct series_step step = series_step_of(own->terms);
    struct cssm *cssm = *state = mem_alloc(1, sizeof *cssm);
    char *defines =
        mem_printf("MAP_COUNT %d;BASIS_TERMS %d;BASIS_GROUPS %d;%s", desc->lights->maps, own->terms,
                   (own->terms + 3) / 4, own->prefilter == PREFILTER_SAT ? "BASIS_SUMS;" : "");
    bool ok = prefiltered_begin(&cssm->prefiltered, desc,
                                &(struct prefiltered_desc){.filter = FILTER_CSSM_WINDOW,
                                                           .search_parts = 8,
                                                           .shadow_parts = 8,
                                                           .defines = defines,
                                                           .shift = (float)step.zero,
                                                           .gain = (float)(1 / step.full)}) &&
              init_bases(cssm, own, desc->lights->maps);
    free(defines);
    if (ok)
        show_bases(cssm);
    return ok;
}

static void render_lights(void *state, const struct frame *frame) {
    struct cssm *cssm = state;
    const struct texture *depth = &cssm->prefiltered.light_maps.maps.depth;
    prefiltered_render_lights(&cssm->prefiltered, frame);
    basis_pass_render(&cssm->basis, frame, depth);
    if (cssm->sums.maps.count)
        sums_pass_render(&cssm->sums, frame, depth, &cssm->basis.maps.ranges);
}

static const struct settings_part *const parts[] = {&own_part, &prefilter_part, &shadow_part, NULL};

extern const struct direct_method cssm_direct;
const struct direct_method cssm_direct = {
    .name = "cssm",
    .help = "soft shadows from filtered Fourier series of depth",
    .parts = parts,
    .init = init,
    .free = free_state,
    .render_lights = render_lights,
    .render_view = shadow_render_view,
    SHADOW_METHOD,
};
