#include "apps/stats.h"

#include "base/memory.h"
#include "gl/memory.h"
#include "shared/vpl.h"

#include <stdio.h>
#include <stdlib.h>

/* VPLs that met something, and VALs that have one. */
static void count_lights(const struct vpl_buffer *vpls, int val_count, int *lit, int *used) {
    struct vpl *all = mem_alloc((size_t)vpls->count, sizeof *all);
    bool *seen = mem_alloc((size_t)val_count, sizeof *seen);
    buffer_read(&vpls->buffer, 0, (size_t)vpls->count * sizeof *all, all);
    *lit = *used = 0;
    for (int i = 0; i < vpls->count; i++) {
        if (all[i].flux[3] <= 0)
            continue;
        (*lit)++;
        int val = (int)all[i].position[3];
        *used += !seen[val];
        seen[val] = true;
    }
    free(all);
    free(seen);
}

static void print_times(struct timers *timers) {
    timers_flush(timers);
    double frame = timer_ms(timers, "frame");
    for (int i = 0; i < timers->count; i++) {
        const struct timer_result *result = &timers->results[i];
        const char *name = result->path;
        for (int depth = 0; depth < result->depth; depth++)
            while (*name++ != '/')
                ;
        printf("  %*s%-*s %9.2f ms %5.1f %%\n", 2 * result->depth, "", 28 - 2 * result->depth, name,
               result->ms, frame > 0 ? 100 * result->ms / frame : 0);
    }
    if (timers->finish)
        printf("  (software OpenGL: each pass timed with glFinish and the clock)\n");
}

void stats_print(struct renderer *renderer) {
    const struct settings *settings = &renderer->desc.settings;
    struct technique_outputs outputs;
    renderer_outputs(renderer, &outputs);
    int lit, used, vals = outputs.val_views ? settings->val_count : 1;
    count_lights(outputs.vpls, vals, &lit, &used);
    printf("faces  %u\n", geometry_triangle_count(renderer->desc.geometry));
    printf("VPLs   %d, of which %d emit\n", settings->vpl_count, lit);
    if (outputs.val_views)
        printf("VALs   %d, of which %d in use\n", vals, used);
    printf("GPU memory\n");
    gpu_memory_print(stdout);
    printf("time per pass\n");
    print_times(&renderer->timers);
}
