#define _POSIX_C_SOURCE 200809L
#include "apps/temporal.h"

#include "apps/bench_plot.h"
#include "apps/bench_reference.h"
#include "measure/lights.h"
#include "measure/progress.h"

#include "base/error.h"
#include "base/memory.h"
#include "base/output_file.h"
#include "gl/memory.h"
#include "scene/animation.h"
#include "shared/vpl.h"

#include <cglm/cglm.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

/* The clustering starts beside what the benchmark compares anyway. */
static const char *const usual_variants[] = {
    "instant-radiosity",
    "paper",
    "fast",
    "warm:technique=clustered,start=warm",
    "reseed:technique=clustered,start=reseed",
};

static const char reference_variant[] = "R:technique=instant-radiosity,interleave=1,blur-radius=0";

enum { VARIANTS_MAX = 8 };

/* One frame of one variant. */
struct temporal_frame {
    double time, flicker; /* seconds; share of mean R, 0 in the first frame */
    int vals;             /* in use; 0 = it has none */
    double center_travel; /* mean over VALs since the frame before, metres */
    double light_travel;  /* likewise of VPLs */
};

/* A variant and what its last frame was. */
struct track {
    struct bench_case prepared;
    struct renderer renderer;
    struct image image, before;
    struct lights lights, lights_before; /* zeroed where the technique has none */
    struct temporal_frame *frames;
};

static bool track_start(struct track *track, const struct bench_values *values,
                        const struct stage *stage, const char *variant, int frames, bool software) {
    *track = (struct track){0};
    if (!bench_prepare(&track->prepared, values, stage, variant) ||
        !bench_case_start(&track->renderer, &track->prepared, stage, software))
        return false;
    track->renderer.timers.enabled = false;
    track->frames = mem_alloc((size_t)frames, sizeof *track->frames);
    return true;
}

static void track_free(struct track *track) {
    renderer_free(&track->renderer);
    image_free(&track->image);
    image_free(&track->before);
    lights_free(&track->lights);
    lights_free(&track->lights_before);
    free(track->frames);
}

/* --- measures --------------------------------------------------------------------------------- */

/* A layer's mean over pixels and colours. */
static double layer_mean(const struct image *image, const int channels[3]) {
    double sum = 0;
    for (int y = 0; y < image->height; y++)
        for (int x = 0; x < image->width; x++)
            for (int c = 0; c < 3; c++)
                sum += (double)image_at(image, x, y)[channels[c]];
    return sum / (3. * image->width * image->height);
}

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

static double vpl_travel(const struct lights *now, const struct lights *before) {
    double sum = 0;
    int counted = 0;
    for (int i = 0; i < now->vpl_count; i++)
        if (now->vpls[i].emits > 0 && before->vpls[i].emits > 0) {
            sum += (double)glm_vec3_distance(now->vpls[i].position, before->vpls[i].position);
            counted++;
        }
    return counted ? sum / counted : 0;
}

static double val_travel(const struct lights *now, const struct lights *before) {
    double sum = 0;
    int counted = 0;
    for (int i = 0; i < now->val_count; i++)
        if (now->centers[i][3] > 0 && before->centers[i][3] > 0) {
            sum += (double)glm_vec3_distance(now->centers[i], before->centers[i]);
            counted++;
        }
    return counted ? sum / counted : 0;
}

static void swap_frames(struct track *track) {
    image_free(&track->before);
    lights_free(&track->lights_before);
    track->before = track->image;
    track->lights_before = track->lights;
    track->image = (struct image){0};
    track->lights = (struct lights){0};
}

static bool track_frame(struct track *track, const struct stage *stage, int index, double time) {
    struct temporal_frame *frame = &track->frames[index];
    frame->time = time;
    swap_frames(track);
    if (!renderer_update(&track->renderer, stage->emitters.items, &stage->camera))
        return false;
    renderer_render(&track->renderer);
    lights_read(&track->lights, &track->renderer);
    frame->vals = track->lights.used;
    if (index > 0) {
        frame->light_travel = vpl_travel(&track->lights, &track->lights_before);
        frame->center_travel = val_travel(&track->lights, &track->lights_before);
    }
    return renderer_read_layers(&track->renderer, &track->image);
}

/* --- a clip ----------------------------------------------------------------------------------- */

struct memory {
    int objects;             /* of OpenGL */
    double on_gpu, resident; /* MiB */
    double most;             /* ever resident, MiB */
};

struct clip_run {
    const struct bench_values *values;
    struct track reference, tracks[VARIANTS_MAX];
    int track_count, frame_count;
    double mean_r;           /* over the frames */
    struct memory memory[2]; /* after a tenth of the clip, and at its end */
};

/* What the process and OpenGL hold. */
static struct memory memory_now(void) {
    struct memory memory = {.objects = gpu_memory_object_count(),
                            .on_gpu = (double)gpu_memory_total() / (1 << 20)};
    struct rusage usage;
    long pages = 0;
    FILE *statm = fopen("/proc/self/statm", "r");
    if (statm && fscanf(statm, "%*d %ld", &pages) == 1)
        memory.resident = (double)pages * (double)sysconf(_SC_PAGESIZE) / (1 << 20);
    if (statm)
        fclose(statm);
    /* The kernel counts the two at different moments. */
    memory.most = memory.resident;
    if (getrusage(RUSAGE_SELF, &usage) == 0)
        memory.most = fmax(memory.most, (double)usage.ru_maxrss / 1024);
    return memory;
}

static void finish_flicker(struct clip_run *run) {
    for (int t = 0; t < run->track_count; t++)
        for (int i = 1; i < run->frame_count; i++)
            run->tracks[t].frames[i].flicker /= run->mean_r / run->frame_count;
}

/* The truth: paths of one bounce, whose seed is the same in all frames, as then is most of the
 * noise. */
static bool trace_frame(struct clip_run *run, const struct stage *stage) {
    const struct bench_case *prepared = &run->reference.prepared;
    swap_frames(&run->reference);
    return bench_reference_trace(
        &(struct bench_reference_desc){.kind = run->values->reference,
                                       .stage = stage,
                                       .width = prepared->width,
                                       .height = prepared->height,
                                       .noise = (double)run->values->noise},
        &run->reference.image);
}

static bool is_traced(const struct bench_values *values) {
    return values->reference == BENCH_REFERENCE_PATH ||
           values->reference == BENCH_REFERENCE_CENTERS;
}

static bool run_frame(struct clip_run *run, struct stage *stage, int index, double time) {
    int of_r[3], of_f[3];
    if (!stage_pose(stage, time) ||
        !(is_traced(run->values) ? trace_frame(run, stage)
                                 : track_frame(&run->reference, stage, index, time)) ||
        !image_find_layer(&run->reference.image, "indirect", of_r))
        return false;
    run->mean_r += layer_mean(&run->reference.image, of_r);
    for (int t = 0; t < run->track_count; t++) {
        struct track *track = &run->tracks[t];
        if (!track_frame(track, stage, index, time) ||
            !image_find_layer(&track->image, "indirect", of_f))
            return false;
        if (index > 0)
            track->frames[index].flicker = excess_change(track, of_f, &run->reference, of_r);
    }
    run->memory[1] = memory_now();
    if (index <= run->frame_count / 10)
        run->memory[0] = run->memory[1];
    return true;
}

static bool run_clip(struct clip_run *run, struct stage *stage) {
    double duration = scene_duration(&stage->scene);
    struct progress progress;
    bool ok = true;
    progress_start(&progress);
    for (int i = 0; ok && i < run->frame_count; i++) {
        ok = run_frame(run, stage, i, duration * i / run->frame_count);
        progress_show(&progress, (i + 1.) / run->frame_count, stage->name);
    }
    progress_end(&progress);
    finish_flicker(run);
    return ok;
}

static bool start_tracks(struct clip_run *run, const struct bench_values *values,
                         const struct stage *stage, bool software) {
    const char *const *variants = values->variants.count ? values->variants.items : usual_variants;
    int count = values->variants.count ? values->variants.count
                                       : (int)(sizeof usual_variants / sizeof *usual_variants);
    if (count > VARIANTS_MAX)
        return error_set("more than %d variants", VARIANTS_MAX);
    if (!track_start(&run->reference, values, stage, reference_variant, run->frame_count, software))
        return false;
    while (run->track_count < count)
        if (!track_start(&run->tracks[run->track_count], values, stage, variants[run->track_count],
                         run->frame_count, software))
            return false;
        else
            run->track_count++;
    return true;
}

static void run_free(struct clip_run *run) {
    track_free(&run->reference);
    for (int t = 0; t < run->track_count; t++)
        track_free(&run->tracks[t]);
}

/* --- results ---------------------------------------------------------------------------------- */

static void print_track(const struct clip_run *run, const struct track *track) {
    double sum = 0, centers = 0, light = 0;
    int worst = 1, least = track->frames[0].vals, most = least;
    for (int i = 0; i < run->frame_count; i++) {
        const struct temporal_frame *frame = &track->frames[i];
        sum += frame->flicker;
        centers += frame->center_travel;
        light += frame->light_travel;
        worst = frame->flicker > track->frames[worst].flicker ? i : worst;
        least = frame->vals < least ? frame->vals : least;
        most = frame->vals > most ? frame->vals : most;
    }
    char vals[32] = "-", travel[32] = "-";
    if (most)
        snprintf(vals, sizeof vals, "%d..%d", least, most);
    if (most && light > 0)
        snprintf(travel, sizeof travel, "%.2f", centers / light);
    printf("  %-20s %8.3f %%  %8.3f %% at %.2f s  %8s  %8s\n", track->prepared.series,
           100 * sum / (run->frame_count - 1), 100 * track->frames[worst].flicker,
           track->frames[worst].time, vals, travel);
}

static void print_memory(const char *when, const struct memory *memory) {
    printf("  %s: %d GL objects of %.1f MiB; %.1f MiB resident, never more than %.1f\n", when,
           memory->objects, memory->on_gpu, memory->resident, memory->most);
}

static void print_run(const struct clip_run *run, const struct stage *stage) {
    printf("%s, %d frames\n  %-20s %10s  %20s  %8s  %8s\n", stage->name, run->frame_count,
           "variant", "flicker", "worst frame", "VALs", "travel");
    for (int t = 0; t < run->track_count; t++)
        print_track(run, &run->tracks[t]);
    printf("  (flicker: change beyond that of %s, over its mean;\n"
           "   travel: of VALs' centres over that of VPLs)\n",
           is_traced(run->values) ? "the path-traced truth" : "all VPLs with a map each");
    print_memory("after a tenth of the clip", &run->memory[0]);
    print_memory("at its end", &run->memory[1]);
}

static void write_rows(FILE *csv, const struct clip_run *run, const struct stage *stage) {
    for (int t = 0; t < run->track_count; t++)
        for (int i = 0; i < run->frame_count; i++) {
            const struct temporal_frame *frame = &run->tracks[t].frames[i];
            fprintf(csv, "%s,%s,%d,%.6g,%.6g,%d,%.6g,%.6g\n", stage->name,
                    run->tracks[t].prepared.series, i, frame->time, frame->flicker, frame->vals,
                    frame->center_travel, frame->light_travel);
        }
}

/* Flicker in per cent, or VALs in use, over time. */
static bool draw(const struct clip_run *run, const struct stage *stage, const char *folder,
                 bool vals) {
    struct plot plot = {.title = stage->name,
                        .x_label = "time, s",
                        .y_label = vals ? "VALs in use" : "flicker, %",
                        .linear_x = true};
    for (int t = 0; t < run->track_count; t++)
        for (int i = 1; i < run->frame_count; i++) {
            const struct temporal_frame *frame = &run->tracks[t].frames[i];
            struct plot_point point = {.x = frame->time,
                                       .y = vals ? frame->vals : 100 * frame->flicker};
            if (!vals || frame->vals)
                plot_add(&plot, run->tracks[t].prepared.series, &point);
        }
    char *path = mem_printf("%s/%s-%s", folder, stage->name, vals ? "vals" : "flicker");
    bool ok = plot.count == 0 || plot_draw(&plot, path);
    free(path);
    plot_free(&plot);
    return ok;
}

static bool bench_clip(const struct bench_values *values, const char *path, struct output_text *csv,
                       bool software) {
    struct stage stage;
    struct clip_run run = {.values = values, .frame_count = values->frames ? values->frames : 50};
    if (!stage_init(&stage, &(struct stage_desc){.path = path}))
        return false;
    bool ok = (run.frame_count > 1 || error_set("flicker needs two frames")) &&
              (scene_duration(&stage.scene) > 0 || error_set("%s: nothing moves", path)) &&
              start_tracks(&run, values, &stage, software) && run_clip(&run, &stage);
    if (ok) {
        print_run(&run, &stage);
        write_rows(csv->stream, &run, &stage);
        ok = (!values->csv || output_text_write(csv, values->csv)) &&
             (!values->output || (draw(&run, &stage, values->output, false) &&
                                  draw(&run, &stage, values->output, true)));
    }
    run_free(&run);
    stage_free(&stage);
    return ok;
}

bool bench_temporal(const struct bench_values *values, const char **scenes, int scene_count,
                    bool software) {
    struct output_text csv;
    output_text_init(&csv);
    fprintf(csv.stream, "scene,variant,frame,time,flicker,vals,center_travel,light_travel\n");
    bool ok = true;
    for (int i = 0; ok && i < scene_count; i++)
        ok = bench_clip(values, scenes[i], &csv, software);
    output_text_free(&csv);
    return ok;
}
