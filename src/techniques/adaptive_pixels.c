#include "techniques/adaptive_pixels.h"

#include <math.h>
#include <string.h>

/* 8 degrees: neighbours within them are gentle relief, which needs no more VPLs than an edge. */
static const float sharp_cosine = .99F;

/* A pixel is adaptive unless all four neighbours half a blur's radius away are on its surface. */
static const float adaptive_share = 1;

/* Returns the side of a square of the picture's area, over 400 pixels; at least 1. */
static float growth_of(int width, int height) {
    static const float side = 400;
    return fmaxf(sqrtf((float)width * (float)height) / side, 1);
}

/* At higher resolution a feature covers more pixels, so each adaptive pixel needs fewer VPLs,
 * visibility tests and near-field samples (docs/notes/blur-and-adaptive-pixels.md). */
static float share_of_large(int width, int height) {
    float growth = growth_of(width, height);
    return 1 / (growth * growth);
}

static int adaptive_slots(const struct gather_desc *adaptive, const struct settings *settings) {
    const struct gather_settings *own = settings_of(struct gather_settings, settings, &gather_part);
    float share = share_of_large(adaptive->width, adaptive->height);
    int times = (int)roundf((float)own->adaptive_factor * share);
    int all = adaptive->interleave * adaptive->interleave;
    return times < 1 ? 1 : times < all ? times : all;
}

/* Visibility tests take most of the time of this gather. Two for a dozen VPLs suffice, in large
 * pictures two for up to twice as many. A rectangle stands for several VPLs, and no blur follows:
 * there are fewer. */
int vpls_together(const struct gather_desc *desc) {
    float growth = fminf(growth_of(desc->width, desc->height), 2);
    return desc->clamp >= GATHER_CLAMP_RECTANGLE ? 4 : (int)(12 * growth);
}

/* Returns the side of the block that holds a pixel's visibility; 0: no block, or four blocks. */
static int block_of_pixel(const struct gather_desc *gather, int block) {
    return gather->clamp >= GATHER_CLAMP_RECTANGLE ? 0 : block;
}

/* Half the blur's radius: farther off an edge the blur finds enough neighbours on one side. */
static int adaptive_radius(const struct settings *settings) {
    int radius = many_lights_blur_radius(settings);
    return radius > 0 ? (radius + 1) / 2 : 2;
}

/* Without interleaving all pixels take all VPLs, and adaptive pixels only test their own
 * visibility. Without a blur, or where all pixels take as many VPLs, no pixel needs more. */
static bool has_adaptive_pixels(const struct settings *settings) {
    const struct gather_settings *own = settings_of(struct gather_settings, settings, &gather_part);
    return own->adaptive > 0 && (own->interleave == 1 ? own->adaptive == 1
                                                      : own->adaptive < own->interleave &&
                                                            many_lights_blur_radius(settings) > 0);
}

bool adaptive_pixels_init(struct many_lights *lights, const struct technique_desc *desc,
                          struct gather_desc *others) {
    const struct gather_settings *gather =
        settings_of(struct gather_settings, desc->settings, &gather_part);
    const struct blur_settings *blur =
        settings_of(struct blur_settings, desc->settings, &blur_part);
    struct gather_desc gather_desc = *others;
    struct adaptive_desc adaptive = {
        .width = desc->width,
        .height = desc->height,
        .interleave = gather->adaptive,
        .radius = adaptive_radius(desc->settings),
        .distance = blur->distance,
        .cosine = blur->cosine,
        .sharp_cosine = fminf(blur->cosine, sharp_cosine),
        .share = adaptive_share,
        .block = block_of_pixel(&gather_desc, lights->visibility.block),
    };
    gather_desc.interleave = gather->adaptive;
    gather_desc.receivers = RECEIVERS_ADAPTIVE;
    gather_desc.share = false;
    gather_desc.list_slots[PIXEL_LEVEL_EDGE] = 1;
    gather_desc.list_slots[PIXEL_LEVEL_DETAIL] = adaptive_slots(&gather_desc, desc->settings);
    gather_desc.list_slots[LIST_EDGE_SAMPLES] = gather->edge_samples;
    gather_desc.together = vpls_together(&gather_desc);
    if (!has_adaptive_pixels(desc->settings))
        return true;
    others->receivers = RECEIVERS_OTHERS;
    return adaptive_pass_init(&lights->adaptive, &adaptive) &&
           gather_pass_init(&lights->adaptive_gather, &gather_desc);
}

void adaptive_pixels_fit_near_field(const struct many_lights *lights,
                                    struct near_field_desc *near_field) {
    const struct gather_desc *adaptive = &lights->adaptive_gather.desc;
    near_field->adaptive = lights->adaptive.program;
    memcpy(near_field->list_slots, adaptive->list_slots, sizeof near_field->list_slots);
    near_field->adaptive_part = fmaxf(share_of_large(adaptive->width, adaptive->height), .5F);
}

/* The more lights a pixel has, the fewer of its neighbours it needs. In a larger picture the same
 * window covers more pixels, so that as much light changes within it. */
void adaptive_pixels_fit_blur(const struct many_lights *lights, struct blur_desc *blur) {
    const struct gather_desc *adaptive = &lights->adaptive_gather.desc;
    float n = (float)lights->gather.desc.interleave,
          growth = growth_of(adaptive->width, adaptive->height);
    blur->adaptive = lights->adaptive.program;
    for (int level = 0; blur->adaptive && level < PIXEL_LEVELS; level++) {
        float slots = (float)adaptive->list_slots[level],
              places = sqrtf(slots) / (float)adaptive->interleave;
        blur->level_radius[level] = fminf(.5f / places * growth, (float)blur->radius);
        blur->level_weight[level] = places * places * (n * n);
    }
}
