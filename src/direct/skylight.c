#include "direct/skylight.h"

#include "scene/environment_fit.h"

#define ROW(name) offsetof(struct skylight_settings, name)

static const char *const fit_names[] = {"rectangles", "even", NULL};

static const struct option table[] = {
    {"lights", 0, OPTION_INT, ROW(lights), 120, SKY_LIGHTS_MIN, SKY_LIGHTS_MAX,
     .help = "area lights that stand for an environment, at most"},
    {"fit", 0, OPTION_CHOICE, ROW(fit), SKY_FIT_EVEN, .choices = fit_names,
     .help =
         "how they are found: rectangles that grow from the brightest texel, or parts that are\n"
         "as even as may be"},
    {"sky-size", 0, OPTION_INT, ROW(map_size), 256, 16, 4096,
     .help = "shadow map of such a light, texels a side"},
    {"sun-maps", 0, OPTION_INT, ROW(sun_maps), 4, 1, 8,
     .help = "of a narrow light that is a good share of all, so many a side"},
    {"sky-block", 0, OPTION_INT, ROW(block), 7, 1, 64,
     .help = "pixels a side of a block that shares its visibility"},
    {"sky-ways", 0, OPTION_INT, ROW(ways), 3, 1, 256,
     .help = "ways to points of a light that a lookup follows; of a sun at least 16"},
    {"sky-bias", 0, OPTION_FLOAT, ROW(bias), .1, 0, 100,
     .help = "what is lower above a receiver's plane hides nothing, in texels"},
    {"disagree", 0, OPTION_FLOAT, ROW(disagree), .02, 0, 2,
     .help = "pixels between blocks that disagree about more than this share of the sky's light\n"
             "look themselves up; of many lights, each of which has little, a smaller share"},
    {NULL},
};

const struct settings_part sky_part = {"sky", "direct light of an environment", table,
                                       sizeof(struct skylight_settings)};

/* Those that the maps of VALs have, so that both share them. */
static const struct caster_desc caster = {.error = .00055F, .long_count = 500};

bool skylight_init(struct skylight *skylight, const struct skylight_desc *desc) {
    const struct skylight_settings *own = settings_of(desc->settings, &sky_part);
    const struct sky_map_layout layout = {
        .size = own->map_size, .count = desc->count, .suns = desc->suns, .sun_maps = own->sun_maps};
    *skylight = (struct skylight){.count = desc->count};
    if (desc->count == 0 ||
        (sky_map_pass_init(&skylight->maps, &(struct sky_map_desc){.casters = desc->casters,
                                                                   .caster = caster,
                                                                   .layout = layout}) &&
         sky_light_pass_init(&skylight->light, &(struct sky_light_desc){.width = desc->width,
                                                                        .height = desc->height,
                                                                        .maps = layout,
                                                                        .block = own->block,
                                                                        .ways = own->ways,
                                                                        .bias = own->bias,
                                                                        .disagree = own->disagree,
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
