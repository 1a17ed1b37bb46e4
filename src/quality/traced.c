#include "quality/traced.h"

#include "gl/context/context.h"
#include "gl/framebuffer.h"
#include "passes/frame.h"
#include "quality/picture.h"
#include "scene/caustics.h"
#include "shared/composite.h"

/* Settings of the path tracer; all others are of frames. */
static const char obeyed[] =
    "lights.bounces lights.seed surface.materials medium.scatter medium.absorb "
    "medium.g medium.scene picture.exposure picture.tone-map";

/* No estimate has these seeds (quality/estimate.h). */
static const uint32_t first_seed = 1U << 30;

bool traced_is_possible(const struct measure_desc *desc) {
    struct settings defaults;
    renderer_settings_init(&defaults);
    for (struct setting setting = {0}; settings_next(&defaults, &setting);)
        if (!setting_equal(&setting, &desc->settings, &defaults) &&
            !setting_is_among(&setting, obeyed))
            return false;
    return gl.software && !caustics_shown(&desc->stage->scene, &desc->settings) &&
           !geometry_has_panes(&desc->stage->geometry); /* frames have them in no layer */
}

static bool show(void *user, const struct path_tracer_progress *progress) {
    if (user)
        progress_show(user, progress->done, "");
    return true;
}

bool traced_render(const struct measure_desc *desc, int samples, bool hides_sky,
                   struct progress *progress, struct image *image) {
    struct path_tracer_desc paths = picture_paths(desc);
    paths.samples = samples;
    paths.seed = first_seed + (uint32_t)measure_setting(desc, "lights.seed");
    paths.denoise = paths.bounces > 0;
    paths.hides_sky = hides_sky;
    paths.progress = show;
    paths.user = progress;
    return picture_trace_paths(desc->stage, &paths, image, NULL);
}

bool traced_show(const struct renderer_desc *desc, const struct stage *stage, int samples,
                 struct progress *progress, struct image *picture) {
    const struct measure_desc measure = measure_of(desc, stage);
    bool hides_sky = desc->background.kind != BACKGROUND_SCENE;
    if (picture->pixels && !hides_sky)
        return true;
    image_free(picture);
    return traced_render(&measure, samples, hides_sky, progress, picture);
}

/* --- display --- */

/* channels: NULL writes 1, with the picture's alpha. */
static void write_rows(const struct texture *texture, const struct image *image,
                       const int *channels) {
    int alpha = image_find_channel(image, "A");
    float *row = mem_alloc(4 * (size_t)image->width, sizeof *row);
    for (int y = 0; y < image->height; y++) {
        for (int x = 0; x < image->width; x++) {
            const float *pixel = image_at(image, x, y);
            for (int c = 0; c < 3; c++)
                row[4 * x + c] = channels ? pixel[channels[c]] : 1;
            row[4 * x + 3] = pixel[alpha];
        }
        gl.TextureSubImage2D(texture->id, 0, 0, image->height - 1 - y, image->width, 1, GL_RGBA,
                             GL_FLOAT, row);
    }
    free(row);
}

static bool write_layer(const struct mean_pass *mean, const struct image *image, int layer) {
    int channels[3];
    if (!image_find_layer(image, shown_layer_prefix(layer), channels))
        return false;
    write_rows(&mean->sums[layer], image, channels);
    return true;
}

/* As a mean of one pass. */
static void draw(const struct mean_pass *mean, const struct renderer_desc *desc, int layer,
                 GLuint framebuffer) {
    struct timers untimed = {0};
    const struct frame frame = {.timers = &untimed};
    const struct picture_settings *picture =
        settings_of(struct picture_settings, &desc->settings, &picture_part);
    mean_pass_render_display(mean, &frame, 1, layer, picture->exposure,
                             picture->tone_map == TONE_MAP_FILMIC, &desc->background, framebuffer);
}

bool traced_display(const struct image *image, const struct renderer_desc *desc, int layer,
                    struct bitmap *bitmap) {
    struct mean_pass mean;
    struct texture display = {0};
    GLuint framebuffer = 0;
    const struct mean_desc size = {.width = image->width, .height = image->height};
    bool ok = mean_pass_init(&mean, &size) &&
              framebuffer_init_target(&display, &framebuffer,
                                      &(struct texture_desc){.label = "display",
                                                             .format = GL_RGBA8,
                                                             .width = image->width,
                                                             .height = image->height}) &&
              write_layer(&mean, image, LAYER_BEAUTY) && write_layer(&mean, image, layer);
    if (ok) {
        /* Where albedos are 1, sums of light are light. */
        write_rows(&mean.sums[LAYER_ALBEDO], image, NULL);
        draw(&mean, desc, layer, framebuffer);
        texture_read_bitmap(&display, bitmap);
        ok = context_check();
    }
    framebuffer_free(&framebuffer);
    texture_free(&display);
    mean_pass_free(&mean);
    return ok;
}
