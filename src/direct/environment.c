#include "direct/environment.h"

#include "base/memory.h"
#include "passes/frame.h"
#include "passes/gather/blur.h"
#include "passes/visibility/environment_lighting.h"

#define ROW(name) offsetof(struct environment_settings, name)

static const char *const fit_names[] = {"rectangles", "even", NULL};

static const struct option table[] = {
    {"lights", 0, OPTION_INT, ROW(lights), 120, ENVIRONMENT_LIGHTS_MIN, ENVIRONMENT_LIGHTS_MAX,
     .label = "area lights",
     .help = "largest number of area lights that\n"
             "approximate an environment map; fewer: faster"},
    {"fit", 0, OPTION_CHOICE, ROW(fit), SKY_FIT_EVEN, .label = "fit", .choices = fit_names,
     .help = "fit of the area lights: rectangles grown from the\n"
             "brightest texel, or cells of nearly even radiance"},
    {"shadow-rays", 0, OPTION_INT, ROW(shadow_rays), 3, 1, 32, .label = "shadow rays",
     .help = "shadow rays per environment light; at least 16 for a sun"},
    {"directions", 0, OPTION_INT, ROW(directions), 12, ENVIRONMENT_LIGHTS_MIN, LIGHTS_MAX,
     .label = "directions",
     .help = "largest number of groups of an environment's lights, each with a view from\n"
             "one direction for near light; VPLs take directions of their own; raise,\n"
             "with lights.vpls, where light comes through windows"},
    {NULL},
};

const struct settings_part sky_part = {"sky", "direct light of an environment", table,
                                       sizeof(struct environment_settings)};

/* Pixels along each side of a block that shares its visibility. */
enum { BLOCK = 4 };

/* Blur of lobes: radius in pixels, and the largest distance of a neighbour, over the picture's
 * height at the pixel's depth. */
enum { LOBE_BLUR = 4 };
static const float lobe_distance = .1F;

/* Where blocks differ by more, over the environment's light, rays start at the pixels between them;
 * of more than 60 lights divided by lights / 60. */
static const float disagree = .02F;

struct lighting {
    struct environment_lighting_pass light;
    struct blur_pass blur;            /* of rays of lobes, with light.desc.specular */
    struct environment_lights lights; /* as the map lies, without its turn and strength */
    struct sky_block block;           /* as it is turned */
    struct buffer buffer;             /* the same, for BLOCK_SKY */
    const struct direct_method *lamps;
    void *lamps_state;
};

static void free_state(void *state) {
    struct lighting *lighting = state;
    if (lighting) {
        environment_lighting_pass_free(&lighting->light);
        blur_pass_free(&lighting->blur);
        buffer_free(&lighting->buffer);
        lighting->lamps->free(lighting->lamps_state);
    }
    free(lighting);
}

static bool init_blur(struct blur_pass *blur, bool specular, int width, int height) {
    const struct blur_desc desc = blur_desc_specular(width, height, LOBE_BLUR, lobe_distance);
    return !specular || blur_pass_init(blur, &desc);
}

static bool init(void **state, const struct direct_desc *desc) {
    const struct environment_settings *own =
        settings_of(struct environment_settings, desc->settings, &sky_part);
    struct lighting *lighting = *state = mem_alloc(1, sizeof *lighting);
    lighting->lights = *desc->sky;
    lighting->lamps = desc->lamps;
    return lighting->lamps->init(&lighting->lamps_state, desc) &&
           environment_lighting_pass_init(
               &lighting->light,
               &(struct environment_lighting_desc){.width = desc->width,
                                                   .height = desc->height,
                                                   .casters = desc->casters,
                                                   .lights = desc->sky->count,
                                                   .suns = environment_lights_suns(desc->sky),
                                                   .bright = environment_lights_bright(desc->sky),
                                                   .block = BLOCK,
                                                   .shadow_rays = own->shadow_rays,
                                                   .disagree = disagree,
                                                   .specular = desc->specular,
                                                   .medium = desc->medium}) &&
           init_blur(&lighting->blur, desc->specular, desc->width, desc->height) &&
           buffer_init(&lighting->buffer, "environment lights", sizeof lighting->block,
                       &lighting->block);
}

static bool resize(void *state, int width, int height) {
    struct lighting *lighting = state;
    const struct environment_lighting_desc old = lighting->light.desc;
    struct blur_pass blur = {0};
    bool ok = init_blur(&blur, old.specular, width, height) &&
              environment_lighting_pass_resize(&lighting->light, width, height);
    if (ok && !lighting->lamps->resize(lighting->lamps_state, width, height)) {
        environment_lighting_pass_resize(&lighting->light, old.width, old.height);
        ok = false;
    }
    blur_pass_free(ok ? &lighting->blur : &blur);
    if (ok)
        lighting->blur = blur;
    return ok;
}

static void render_lights(void *state, const struct frame *frame) {
    struct lighting *lighting = state;
    const int count = lighting->lights.count;
    if (lighting->lamps->render_lights)
        lighting->lamps->render_lights(lighting->lamps_state, frame);
    sky_block_of(&lighting->block, &lighting->lights, frame->emitters->sky);
    buffer_write(&lighting->buffer, 0, (size_t)count * sizeof *lighting->block.sources,
                 lighting->block.sources);
    environment_lighting_pass_render_lights(&lighting->light, frame, &lighting->buffer);
}

static void render_view(void *state, const struct frame *frame, const struct gbuffer *gbuffer) {
    struct lighting *lighting = state;
    const struct direct_method *lamps = lighting->lamps;
    struct environment_lighting_inputs inputs = {
        .lights = &lighting->buffer,
        .direct = lamps->light(lighting->lamps_state),
    };
    lamps->render_view(lighting->lamps_state, frame, gbuffer);
    if (lighting->light.desc.specular) {
        inputs.specular = lamps->specular(lighting->lamps_state);
        environment_lighting_pass_render_lobes(&lighting->light, frame, gbuffer, inputs.lights);
        inputs.reflected =
            &blur_pass_first(&lighting->blur, frame, gbuffer, &lighting->light.lobes)->texture;
    }
    environment_lighting_pass_render(&lighting->light, frame, gbuffer, &inputs);
}

static const struct texture *light(const void *state) {
    const struct lighting *lighting = state;
    return &lighting->light.light;
}

static const struct texture *specular(const void *state) {
    const struct lighting *lighting = state;
    return &lighting->light.specular;
}

const struct direct_method environment_direct = {
    .name = "environment",
    .init = init,
    .free = free_state,
    .resize = resize,
    .render_lights = render_lights,
    .render_view = render_view,
    .light = light,
    .specular = specular,
};
