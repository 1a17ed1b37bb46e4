#include "viewer/reference/tracing.h"

#include "metrics/layer.h"
#include "shared/composite.h"
#include "viewer/picture/preset.h"
#include "viewer/scene/sessions.h"

#include <math.h>

/* Where it ends by itself. */
static const double noise_wanted = .01;

void viewer_trace(struct viewer *viewer) {
    struct tracing *tracing = &viewer->tracing;
    viewer_forget_reference(viewer);
    struct session session = viewer_session(viewer);
    const struct traced_view view = {&session, session_bounces(&session), noise_wanted, window_wake,
                                     viewer->document.scene.punctual_given};
    if (reference_tracer_start(&tracing->tracer, &view)) {
        tracing->view = session_copy(&session);
        tracing->of_view = true;
        /* Errors need pictures of one size, whatever becomes of the window. */
        viewer->shown.fixed_width = session.width;
        viewer->shown.fixed_height = session.height;
    } else {
        viewer_tell_error(viewer);
    }
    session_free(&session);
}

void viewer_forget_reference(struct viewer *viewer) {
    struct tracing *tracing = &viewer->tracing;
    struct compare *compare = &viewer->shown.compare;
    reference_tracer_stop(&tracing->tracer);
    if (tracing->view.lights) {
        reference_free(&compare->reference);
        if (compare->mode == COMPARE_REFERENCE)
            compare->mode = COMPARE_OFF;
        compare->measured = false;
        viewer->shown.fixed_width = viewer->shown.fixed_height = 0;
        viewer->shown.right = NULL;
        viewer->shown.recompose = true;
    }
    session_free(&tracing->view);
    method_table_free(&tracing->table);
    *tracing = (struct tracing){0};
}

bool viewer_is_tracing(const struct viewer *viewer) {
    return atomic_load(&viewer->tracing.tracer.state) == TRACER_TRACING;
}

static double mean_of(const struct image *picture, const char *name) {
    struct image layer;
    double sum = 0;
    if (!layer_extract(&layer, picture, name))
        return 0;
    size_t count = 3 * (size_t)layer.width * (size_t)layer.height;
    for (size_t i = 0; i < count; i++)
        sum += (double)layer.pixels[i];
    image_free(&layer);
    return sum / (double)count;
}

/* The noise that is known is the indirect light's. */
static void tell_noise(struct tracing *tracing, const struct image *picture, double noise) {
    double full = mean_of(picture, "");
    tracing->noise = noise;
    tracing->full_noise = full > 0 ? noise * mean_of(picture, "indirect") / full : 0;
}

double viewer_reference_noise(const struct viewer *viewer) {
    const struct tracing *tracing = &viewer->tracing;
    switch (viewer->shown.layer) {
    case LAYER_INDIRECT:
        return tracing->noise;
    case LAYER_DIRECT:
        return 0;
    default:
        return tracing->full_noise;
    }
}

static double without_noise(double error, double noise) {
    return sqrt(fmax(error * error - noise * noise, 0));
}

bool viewer_compared_error(const struct viewer *viewer, double *error) {
    const struct compare *compare = &viewer->shown.compare;
    int metric = (int)(metric_find("relative-rmse") - metrics);
    bool is_reference = compare->mode == COMPARE_REFERENCE;
    if (!compare->measured || !compare->has_values)
        return false;
    *error =
        without_noise(compare->values[metric], is_reference ? viewer_reference_noise(viewer) : 0);
    return true;
}

/* The first of a view opens the wipe, unless the picture has got another size. */
static void show_picture(struct viewer *viewer, struct traced_picture *newest) {
    struct tracing *tracing = &viewer->tracing;
    struct compare *compare = &viewer->shown.compare;
    tell_noise(tracing, &newest->image, newest->noise);
    if (!reference_take(&compare->reference, &newest->image)) {
        viewer_tell_error(viewer);
        viewer_forget_reference(viewer);
        return;
    }
    if (tracing->samples == 0 && viewer->shown.fixed_width > 0)
        compare->mode = COMPARE_REFERENCE;
    tracing->samples = newest->samples;
    compare->measured = false;
    viewer->shown.recompose = true;
}

/* Relative RMSE of an indirect layer without the reference's noise. False: there is no reference of
 * its size. */
static bool indirect_error(const struct viewer *viewer, const struct image *indirect,
                           double *error) {
    const struct tracing *tracing = &viewer->tracing;
    struct image reference;
    if (tracing->samples == 0 ||
        !layer_extract(&reference, &viewer->shown.compare.reference.picture, "indirect"))
        return false;
    const struct comparison comparison = {.test = indirect, .reference = &reference};
    bool same_size = reference.width == indirect->width && reference.height == indirect->height;
    if (same_size)
        *error = without_noise(metric_measure(metric_find("relative-rmse"), &comparison, NULL),
                               tracing->noise);
    image_free(&reference);
    return same_size;
}

/* Of a picture at rest, when it or the reference is new. */
static void measure(struct viewer *viewer) {
    struct tracing *tracing = &viewer->tracing;
    struct shown *shown = &viewer->shown;
    struct image all = {0}, indirect = {0};
    if (tracing->samples == 0 || shown->moving || shown->dirty || shown->coarse ||
        (tracing->error_frame == shown->frame_count && tracing->error_samples == tracing->samples))
        return;
    tracing->has_error = tracing->of_view && renderer_read_layers(&shown->renderer, &all) &&
                         layer_extract(&indirect, &all, "indirect") &&
                         indirect_error(viewer, &indirect, &tracing->error);
    tracing->error_frame = shown->frame_count;
    tracing->error_samples = tracing->samples;
    shown->recompose = true; /* reading layers used the display's framebuffer state */
    images_free(&all, &indirect);
}

/* What is traced for a view that is left is of no use; the picture stays, should one come back. */
static void follow_view(struct viewer *viewer) {
    struct tracing *tracing = &viewer->tracing;
    if (viewer->shown.moving || !tracing->view.lights)
        return;
    struct session session = viewer_session(viewer);
    bool was = tracing->of_view;
    tracing->of_view = session_same_view(&session, &tracing->view);
    session_free(&session);
    if (was == tracing->of_view)
        return;
    tracing->error_frame = -1;
    if (!tracing->of_view && viewer_is_tracing(viewer))
        reference_tracer_stop(&tracing->tracer);
}

/* --- the table --- */

void viewer_measure(struct viewer *viewer) {
    struct tracing *tracing = &viewer->tracing;
    if (!tracing->view.lights || !tracing->of_view)
        viewer_trace(viewer);
    method_table_plan(&tracing->table, viewer->wish.technique, &viewer->wish.settings);
    tracing->table_samples = 0;
}

bool viewer_is_measuring(const struct viewer *viewer) {
    const struct method_table *table = &viewer->tracing.table;
    return table->next < table->count;
}

void viewer_take_row(struct viewer *viewer, int i) {
    const struct method_row *row = &viewer->tracing.table.rows[i];
    struct settings settings = row->settings;
    preset_keep_tone(&settings, &viewer->wish.settings);
    viewer->wish.technique = row->technique;
    viewer->wish.settings = settings;
    viewer_touch(viewer);
}

/* Against what has been traced so far. */
static void tell_errors(struct viewer *viewer) {
    struct tracing *tracing = &viewer->tracing;
    struct method_table *table = &tracing->table;
    if (tracing->table_samples == tracing->samples)
        return;
    tracing->table_samples = tracing->samples;
    for (int i = 0; i < table->count; i++)
        table->rows[i].has_error =
            table->rows[i].state == ROW_MEASURED &&
            indirect_error(viewer, &table->rows[i].indirect, &table->rows[i].error);
}

/* A row a turn: it takes its time, and the panel says so first. Times are taken while nothing is
 * traced, once there is a reference at all. */
static void follow_table(struct viewer *viewer) {
    struct tracing *tracing = &viewer->tracing;
    struct method_table *table = &tracing->table;
    if (tracing->samples == 0 || !tracing->of_view || viewer->shown.moving)
        return;
    if (viewer_is_measuring(viewer) && table->is_announced) {
        reference_tracer_pause(&tracing->tracer, true);
        struct renderer_desc desc = viewer->shown.renderer.desc;
        desc.width = tracing->view.width; /* whatever has become of the window */
        desc.height = tracing->view.height;
        if (!method_table_measure_next(table, &desc))
            viewer_tell_error(viewer);
        tracing->table_samples = 0;
        reference_tracer_pause(&tracing->tracer, viewer_is_measuring(viewer));
        viewer->shown.recompose = true;
    } else {
        table->is_announced = viewer_is_measuring(viewer);
    }
    tell_errors(viewer);
}

void viewer_follow_reference(struct viewer *viewer) {
    struct tracing *tracing = &viewer->tracing;
    struct traced_picture newest;
    follow_view(viewer);
    if (reference_tracer_poll(&tracing->tracer, &newest) == TRACER_FAILED)
        viewer_tell_error(viewer);
    if (newest.image.pixels)
        show_picture(viewer, &newest);
    measure(viewer);
    follow_table(viewer);
}
