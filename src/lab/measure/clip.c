#include "lab/measure/clip.h"

#include "base/error.h"
#include "base/memory.h"
#include "gl/memory.h"
#include "inspect/lights.h"
#include "scene/animation.h"
#include "shared/vpl.h"

#include <cglm/cglm.h>
#include <math.h>
#include <stdio.h>

/* What is told of each frame. */
enum { FLICKER, VALS, VAL_TRAVEL, VPL_TRAVEL, FIGURES };

static const struct {
    const char *name, *unit;
} figures[FIGURES] = {
    {"frame-flicker", "%"}, {"vals", ""}, {"val-travel", "m"}, {"vpl-travel", "m"}};

/* A subject and what its last frame was. */
struct track {
    const struct measure_desc *desc;
    struct renderer renderer;
    struct image image, before;
    struct lights lights, lights_before; /* zeroed where the technique has none */
    double (*frames)[FIGURES];
};

struct run {
    const struct clip_desc *clip;
    struct results *results;
    struct track reference, *tracks;
    double mean_r; /* over the frames */
};

static bool is_traced(const struct clip_desc *clip) {
    return clip->reference.kind == REFERENCE_PATH || clip->reference.kind == REFERENCE_CENTERS;
}

static bool track_start(struct track *track, const struct measure_desc *desc, int frames) {
    track->desc = desc;
    track->frames = mem_alloc((size_t)frames, sizeof *track->frames);
    bool ok = measure_start(&track->renderer, desc);
    track->renderer.timers.enabled = false;
    return ok;
}

static void track_free(struct track *track) {
    renderer_free(&track->renderer);
    images_free(&track->image, &track->before);
    lights_free(&track->lights);
    lights_free(&track->lights_before);
    free(track->frames);
}

/* --- measures --------------------------------------------------------------------------------- */

static double change(const struct track *track, int x, int y, int channel) {
    return (double)image_at(&track->image, x, y)[channel] -
           (double)image_at(&track->before, x, y)[channel];
}

/* The change of F beyond that of R, mean over pixels and colours. */
static double excess_change(const struct track *f, const int of_f[3], const struct track *r,
                            const int of_r[3]) {
    double sum = 0;
    for (int y = 0; y < f->image.height; y++)
        for (int x = 0; x < f->image.width; x++)
            for (int c = 0; c < 3; c++)
                sum += fabs(change(f, x, y, of_f[c]) - change(r, x, y, of_r[c]));
    return sum / (3. * f->image.width * f->image.height);
}

/* Mean distance between places of so many floats each, of which one at `weight` tells whether the
 * place counts. */
static double mean_travel(const float *now, const float *before, int count, size_t floats,
                          size_t weight) {
    double sum = 0;
    int counted = 0;
    for (; count > 0; count--, now += floats, before += floats)
        if (now[weight] > 0 && before[weight] > 0) {
            sum += (double)glm_vec3_distance((float *)now, (float *)before);
            counted++;
        }
    return counted ? sum / counted : 0;
}

static void measure_travel(const struct track *track, double frame[FIGURES]) {
    const struct lights *now = &track->lights, *before = &track->lights_before;
    if (now->vpl_count)
        frame[VPL_TRAVEL] = mean_travel(now->vpls->position, before->vpls->position, now->vpl_count,
                                        sizeof *now->vpls / sizeof(float),
                                        offsetof(struct vpl, reach) / sizeof(float));
    if (now->val_count)
        frame[VAL_TRAVEL] = mean_travel(*now->centers, *before->centers, now->val_count, 4, 3);
}

/* When memory is looked at. */
enum { EARLY, LATE, LOOKS };

static struct measure_desc memory_desc(const struct run *run, int look) {
    static const char *const looks[LOOKS] = {"after a tenth of the clip", "at its end"};
    struct measure_desc desc = run->clip->all_vpls;
    snprintf(desc.variant, sizeof desc.variant, "memory");
    snprintf(desc.point, sizeof desc.point, "%s", looks[look]);
    return desc;
}

/* What the process and OpenGL hold. */
static void add_memory(struct run *run, int look) {
    struct measure_desc desc = memory_desc(run, look);
    double resident = mem_resident();
    results_begin(run->results, &desc);
    results_add(run->results, "gl-objects", "", "", gpu_memory_object_count());
    results_add(run->results, "gpu-memory", "", "MiB", (double)gpu_memory_total() / (1 << 20));
    results_add(run->results, "resident-memory", "", "MiB", resident);
    /* The kernel counts the two at different moments. */
    results_add(run->results, "most-resident", "", "MiB", fmax(resident, mem_most_resident()));
}

/* --- a clip ----------------------------------------------------------------------------------- */

/* Makes room for a frame, and renders it. */
static bool render_frame(struct track *track) {
    if (!stage_show(track->desc->stage, &track->renderer))
        return false;
    renderer_render(&track->renderer);
    lights_read(&track->lights, &track->renderer);
    return renderer_read_layers(&track->renderer, &track->image);
}

static void next_frame(struct track *track) {
    image_free(&track->before);
    lights_free(&track->lights_before);
    track->before = track->image;
    track->lights_before = track->lights;
    track->image = (struct image){0};
    track->lights = (struct lights){0};
}

/* Of paths the seed is the same in all frames, as then is most of the noise. */
static bool make_reference(struct run *run, int of_r[3]) {
    struct track *r = &run->reference;
    next_frame(r);
    if (!(is_traced(run->clip)
              ? reference_trace(&run->clip->reference, &run->clip->all_vpls, &r->image)
              : render_frame(r)) ||
        !image_find_layer(&r->image, "indirect", of_r))
        return false;
    run->mean_r += image_mean(&r->image, of_r) / run->clip->frames;
    return true;
}

static bool track_frame(struct track *track, const struct track *reference, const int of_r[3],
                        int index) {
    double *frame = track->frames[index];
    int of_f[3];
    next_frame(track);
    if (!render_frame(track) || !image_find_layer(&track->image, "indirect", of_f))
        return false;
    frame[VALS] = track->lights.used;
    if (index == 0)
        return true;
    frame[FLICKER] = 100 * excess_change(track, of_f, reference, of_r);
    measure_travel(track, frame);
    return true;
}

static double time_of(const struct clip_desc *clip, int frame) {
    return scene_duration(&clip->stage->scene) * frame / clip->frames;
}

static struct measure_desc frame_desc(const struct run *run, const struct measure_desc *of,
                                      int frame) {
    struct measure_desc desc = *of;
    snprintf(desc.point, sizeof desc.point, "time=%.6g", time_of(run->clip, frame));
    return desc;
}

int clip_subjects(const struct clip_desc *clip) {
    return LOOKS + clip->subjects->count * (clip->frames + 1);
}

static bool run_frames(struct run *run) {
    const struct clip_desc *clip = run->clip;
    int of_r[3];
    bool ok = true;
    for (int i = 0; ok && i < clip->frames; i++) {
        ok = stage_pose(clip->stage, time_of(clip, i)) && make_reference(run, of_r);
        for (int t = 0; ok && t < clip->subjects->count; t++)
            ok = track_frame(&run->tracks[t], &run->reference, of_r, i);
        if (i == clip->frames / 10)
            add_memory(run, EARLY);
        struct measure_desc at = frame_desc(run, &clip->all_vpls, i);
        results_tell_work(run->results, &at, (i + 1.) / clip->frames * clip_subjects(clip));
    }
    add_memory(run, LATE);
    return ok;
}

/* --- results ---------------------------------------------------------------------------------- */

static bool has(const struct track *track, int figure) {
    return figure == FLICKER ||
           (figure == VPL_TRAVEL ? track->lights.vpl_count : track->lights.val_count);
}

static void add_frames(struct run *run, const struct track *track) {
    for (int i = 0; i < run->clip->frames; i++) {
        struct measure_desc desc = frame_desc(run, track->desc, i);
        results_begin(run->results, &desc);
        track->frames[i][FLICKER] /= run->mean_r;
        for (int k = 0; k < FIGURES; k++)
            if (has(track, k))
                results_add(run->results, figures[k].name, "", figures[k].unit,
                            track->frames[i][k]);
    }
}

static void add_track(struct run *run, const struct track *track) {
    double sums[FIGURES] = {0}, least = INFINITY, most = 0;
    int worst = 0, count = run->clip->frames;
    for (int i = 0; i < count; i++) {
        const double *frame = track->frames[i];
        for (int k = 0; k < FIGURES; k++)
            sums[k] += frame[k];
        worst = frame[FLICKER] > track->frames[worst][FLICKER] ? i : worst;
        least = fmin(least, frame[VALS]);
        most = fmax(most, frame[VALS]);
    }
    results_begin(run->results, track->desc);
    results_add(run->results, "flicker", "", "%", sums[FLICKER] / (count - 1));
    results_add(run->results, "worst-flicker", "", "%", track->frames[worst][FLICKER]);
    results_add(run->results, "worst-time", "", "s", time_of(run->clip, worst));
    if (!has(track, VALS))
        return;
    results_add(run->results, "least-vals", "", "", least);
    results_add(run->results, "most-vals", "", "", most);
    if (sums[VPL_TRAVEL] > 0)
        results_add(run->results, "travel", "", "m/m", sums[VAL_TRAVEL] / sums[VPL_TRAVEL]);
}

static bool check(const struct clip_desc *clip) {
    return (clip->frames >= 2 || error_set("flicker needs two frames")) &&
           (scene_duration(&clip->stage->scene) > 0 ||
            error_set("%s: nothing moves", clip->stage->name));
}

bool clip_measure(struct results *results, const struct clip_desc *clip) {
    struct run run = {.clip = clip, .results = results};
    if (!check(clip))
        return false;
    run.tracks = mem_alloc((size_t)clip->subjects->count, sizeof *run.tracks);
    bool ok = is_traced(clip) || track_start(&run.reference, &clip->all_vpls, clip->frames);
    for (int t = 0; ok && t < clip->subjects->count; t++)
        ok = track_start(&run.tracks[t], &clip->subjects->items[t], clip->frames);
    ok = ok && run_frames(&run);
    for (int t = 0; t < clip->subjects->count; t++) {
        if (ok) {
            add_frames(&run, &run.tracks[t]);
            add_track(&run, &run.tracks[t]);
        }
        track_free(&run.tracks[t]);
    }
    track_free(&run.reference);
    free(run.tracks);
    return ok && results_commit(results);
}
