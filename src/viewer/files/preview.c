#include "viewer/files/preview.h"

#include "base/log.h"
#include "viewer/scene/develop.h"

#include <math.h>

/* The first picture takes a few tenths of a second with this many pixels. */
static const double most_pixels = 40000;

static bool go_on(void *user, const struct path_tracer_progress *progress) {
    struct preview *preview = user;
    (void)progress;
    return !atomic_load(&preview->cancelled);
}

static void show(struct preview *preview, const struct image *image) {
    struct bitmap bitmap;
    float exposure = preview->desc.auto_exposure ? develop_exposure(image) : preview->desc.exposure;
    develop_picture(image, exposure, &bitmap);
    pthread_mutex_lock(&preview->lock);
    bitmap_free(&preview->newest);
    preview->newest = bitmap;
    pthread_mutex_unlock(&preview->lock);
    atomic_store(&preview->is_new, true);
    preview->desc.wake();
}

/* So many samples a pixel, of light that is reflected once at most. */
static bool trace(struct preview *preview, int samples) {
    const struct preview_desc *wanted = &preview->desc;
    double scale = sqrt(most_pixels / ((double)wanted->width * wanted->height));
    scale = fmin(scale, 1);
    const struct path_tracer_desc desc = {
        .scene = wanted->scene,
        .geometry = wanted->geometry,
        .camera = &wanted->camera,
        .emitters = wanted->emitters,
        .width = (int)fmax(16, scale * wanted->width),
        .height = (int)fmax(16, scale * wanted->height),
        .bounces = 1,
        .medium = wanted->scene->medium,
        .samples = samples,
        .paths = 1,
        .centers = true,
        .denoise = true,
        .threads = 1,
        .progress = go_on,
        .user = preview,
    };
    struct image image;
    if (!path_tracer_render(&desc, &image, NULL))
        return false;
    show(preview, &image);
    image_free(&image);
    return true;
}

/* Each picture takes more time than those before it together. */
static void *trace_all(void *user) {
    static const int samples[] = {1, 4, 16};
    struct preview *preview = user;
    bool ok = true;
    log_tell_of_thread(false);
    for (size_t i = 0; ok && i < sizeof samples / sizeof *samples; i++)
        ok = trace(preview, samples[i]);
    return NULL;
}

void preview_start(struct preview *preview, const struct preview_desc *desc) {
    preview_free(preview);
    preview->desc = *desc;
    preview->desc.emitters = emitters_copy(&desc->emitters);
    pthread_mutex_init(&preview->lock, NULL);
    preview->has_thread = pthread_create(&preview->thread, NULL, trace_all, preview) == 0;
    if (!preview->has_thread) {
        pthread_mutex_destroy(&preview->lock);
        emitters_free(&preview->desc.emitters);
    }
}

bool preview_has_news(struct preview *preview) {
    return atomic_load(&preview->is_new);
}

static void take(struct preview *preview) {
    struct texture texture;
    pthread_mutex_lock(&preview->lock);
    bool ok = texture_init_bitmap(&texture, "coarse picture", &preview->newest);
    pthread_mutex_unlock(&preview->lock);
    if (!ok)
        return;
    texture_free(&preview->texture);
    preview->texture = texture;
    preview->has_texture = true;
}

const struct texture *preview_picture(struct preview *preview) {
    if (preview->has_thread && atomic_exchange(&preview->is_new, false))
        take(preview);
    return preview->has_texture ? &preview->texture : NULL;
}

void preview_stop(struct preview *preview) {
    if (!preview->has_thread)
        return;
    atomic_store(&preview->cancelled, true);
    pthread_join(preview->thread, NULL);
    preview_picture(preview);
    preview->has_thread = false;
    pthread_mutex_destroy(&preview->lock);
    bitmap_free(&preview->newest);
    emitters_free(&preview->desc.emitters);
}

void preview_free(struct preview *preview) {
    preview_stop(preview);
    texture_free(&preview->texture);
    *preview = (struct preview){0};
}
