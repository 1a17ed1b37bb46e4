#include "measure/lights.h"

#include "base/error.h"
#include "base/memory.h"
#include "shared/vpl.h"

#include <stdlib.h>

static void count(struct lights *lights) {
    bool *seen = mem_alloc((size_t)lights->val_count + 1, sizeof *seen);
    for (int i = 0; i < lights->vpl_count; i++) {
        if (lights->vpls[i].emits <= 0)
            continue;
        lights->lit++;
        int val = lights->val_count ? (int)lights->vpls[i].val : 0;
        lights->used += lights->val_count && !seen[val];
        seen[val] = true;
    }
    free(seen);
}

static void read_centers(struct lights *lights, const struct texture *positions) {
    lights->val_count = positions->desc.width;
    lights->centers = mem_alloc((size_t)lights->val_count, sizeof *lights->centers);
    gl.GetTextureImage(positions->id, 0, GL_RGBA, GL_FLOAT,
                       (GLsizei)((size_t)lights->val_count * sizeof *lights->centers),
                       lights->centers);
}

bool lights_read(struct lights *lights, struct renderer *renderer) {
    struct technique_outputs outputs = {0};
    *lights = (struct lights){0};
    renderer_outputs(renderer, &outputs);
    if (!outputs.vpls)
        return error_set("technique '%s' has no VPLs", renderer->technique->name);
    lights->vpl_count = outputs.vpls->count;
    size_t bytes = (size_t)lights->vpl_count * sizeof *lights->vpls;
    lights->vpls = mem_alloc(bytes, 1);
    buffer_read(&outputs.vpls->buffer, 0, bytes, lights->vpls);
    if (outputs.val_positions)
        read_centers(lights, outputs.val_positions);
    count(lights);
    return true;
}

void lights_free(struct lights *lights) {
    free(lights->vpls);
    free(lights->centers);
    *lights = (struct lights){0};
}
