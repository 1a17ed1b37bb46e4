#include "direct/skylight.h"

#include "lights/environment_fit.h"

#define ROW(name) offsetof(struct skylight_settings, name)

static const char *const fit_names[] = {"rectangles", "even", NULL};

static const struct option table[] = {
    {"lights", 0, OPTION_INT, ROW(lights), 120, SKY_LIGHTS_MIN, SKY_LIGHTS_MAX,
     .help = "largest number of area lights that\n"
             "approximate an environment map; fewer: faster"},
    {"fit", 0, OPTION_CHOICE, ROW(fit), SKY_FIT_EVEN, .choices = fit_names,
     .help = "fit of the area lights: rectangles grown from the\n"
             "brightest texel, or cells of nearly even radiance"},
    {"map-size", 0, OPTION_INT, ROW(map_size), 256, 16, 4096,
     .help = "texels along each side of the shadow map of an environment light"},
    {"shadow-rays", 0, OPTION_INT, ROW(shadow_rays), 3, 1, 256,
     .help = "shadow rays per lookup of an environment light; at least 16 for a sun"},
    {"directions", 0, OPTION_INT, ROW(directions), 12, SKY_LIGHTS_MIN, LIGHTS_MAX,
     .help = "largest number of directions from which an environment's reflected\n"
             "light starts; raise, with lights.vpls, where it comes through windows"},
    {NULL},
};

const struct settings_part sky_part = {"sky", "direct light of an environment", table,
                                       sizeof(struct skylight_settings)};

enum {
    SUN_MAPS =
        4, /* maps along each side of a sun: a light below .01 sr with at least 1/40 of the light */
    BLOCK = 7, /* pixels along each side of a block that shares its visibility */
};

/* Height above the receiver's plane up to which nothing casts a shadow, in texels of a map. */
static const float bias = .1F;

/* Blocks that differ by more, over the environment's light, leave the pixels between them their own lookups; of more than
 * 60 lights divided by lights / 60. */
static const float disagree = .02F;

/* Those that the maps of VALs have, so that both share them. */
static const struct caster_desc caster = {.error = .00055F, .long_count = 500};

bool skylight_init(struct skylight *skylight, const struct skylight_desc *desc) {
    const struct skylight_settings *own =
        settings_of(struct skylight_settings, desc->settings, &sky_part);
    const struct sky_map_layout layout = {
        .size = own->map_size, .count = desc->count, .suns = desc->suns, .sun_maps = SUN_MAPS};
    *skylight = (struct skylight){.count = desc->count};
    if (desc->count == 0 ||
        (sky_map_pass_init(&skylight->maps, &(struct sky_map_desc){.casters = desc->casters,
                                                                   .caster = caster,
                                                                   .layout = layout}) &&
         sky_light_pass_init(&skylight->light, &(struct sky_light_desc){.width = desc->width,
                                                                        .height = desc->height,
                                                                        .maps = layout,
                                                                        .block = BLOCK,
                                                                        .ways = own->shadow_rays,
                                                                        .bias = bias,
                                                                        .disagree = disagree,
                                                                        .gloss = desc->gloss}) &&
         buffer_init(&skylight->lights, "lights of the sky", sizeof(struct sky_block), NULL)))
        return true;
    skylight_free(skylight);
    return false;
}

void skylight_free(struct skylight *skylight) {
    sky_map_pass_free(&skylight->maps);
    sky_light_pass_free(&skylight->light);
    buffer_free(&skylight->lights);
    *skylight = (struct skylight){0};
}

bool skylight_resize(struct skylight *skylight, int width, int height) {
    return skylight->count == 0 || sky_light_pass_resize(&skylight->light, width, height);
}

void skylight_write(struct skylight *skylight, const struct sky_block *block) {
    if (skylight->count)
        buffer_write(&skylight->lights, 0, (size_t)skylight->count * sizeof *block->sources,
                     block->sources);
}

void skylight_render_lights(const struct skylight *skylight, const struct frame *frame) {
    if (!skylight->count)
        return;
    sky_map_pass_render(&skylight->maps, frame, &skylight->lights);
    sky_light_pass_render_lights(&skylight->light, frame, &skylight->lights);
}

void skylight_render_view(const struct skylight *skylight, const struct frame *frame,
                          const struct gbuffer *gbuffer, const struct texture *direct,
                          const struct texture *specular) {
    if (skylight->count)
        sky_light_pass_render(
            &skylight->light, frame, gbuffer,
            &(struct sky_light_inputs){&skylight->lights, &skylight->maps.maps, direct, specular});
}

const struct texture *skylight_light(const struct skylight *skylight,
                                     const struct texture *direct) {
    return skylight->count ? &skylight->light.light : direct;
}

const struct texture *skylight_specular(const struct skylight *skylight,
                                        const struct texture *specular) {
    return skylight->count ? &skylight->light.specular : specular;
}
