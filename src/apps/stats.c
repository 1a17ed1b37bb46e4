#include "apps/stats.h"

#include "gl/memory.h"
#include "inspect/lights.h"
#include "techniques/many_lights.h"

#include <stdio.h>
#include <string.h>

static void print_times(FILE *out, struct timers *timers) {
    timers_flush(timers);
    double frame = timer_ms(timers, "frame");
    for (int i = 0; i < timers->count; i++) {
        const struct timer_result *result = &timers->results[i];
        const char *slash = strrchr(result->path, '/');
        fprintf(out, "  %*s%-*s %9.2f ms %5.1f %%\n", 2 * result->depth, "", 28 - 2 * result->depth,
                slash ? slash + 1 : result->path, result->ms,
                frame > 0 ? 100 * result->ms / frame : 0);
    }
    if (timers->finish)
        fprintf(out, "  (software OpenGL: each pass timed with glFinish and the clock)\n");
}

/* Passes of the technique that other settings or scenes would have. */
static void print_left_out(FILE *out, const struct renderer *renderer) {
    const struct step *step = renderer->technique->steps;
    for (; step && step->timer; step++)
        if (!step_runs(step, renderer->technique_state))
            fprintf(out, "  %-28s needs %s\n", step->timer, step->when);
}

static bool is_by_rays(const struct renderer *renderer) {
    const struct renderer_desc *desc = &renderer->desc;
    return renderer->technique->by_rays(&desc->settings, desc->scene, desc->geometry);
}

void stats_print(FILE *out, struct renderer *renderer) {
    struct lights lights;
    fprintf(out, "faces  %u\n", geometry_triangle_count(renderer->desc.geometry));
    if (renderer->technique->by_rays)
        fprintf(out, "indirect visibility by %s\n", is_by_rays(renderer) ? "rays" : "maps");
    if (lights_read(&lights, renderer)) {
        fprintf(out, "VPLs   %d, of which %d emit\n", lights.vpl_count, lights.lit);
        if (lights.val_count)
            fprintf(out, "VALs   %d, of which %d in use\n", lights.val_count, lights.used);
        if (lights.area_count)
            fprintf(out, "area lights %d, of which %d in use\n", lights.area_count,
                    lights.area_used);
        lights_free(&lights);
    }
    fprintf(out, "GPU memory\n");
    gpu_memory_print(out);
    fprintf(out, "time per pass\n");
    print_times(out, &renderer->timers);
    print_left_out(out, renderer);
}
