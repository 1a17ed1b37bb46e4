#include "inspect/lights.h"

#include "base/error.h"
#include "base/memory.h"
#include "passes/vpls.h"
#include "shared/vpl.h"

static void count(struct lights *lights) {
    bool *seen = mem_alloc((size_t)lights->val_count + 1, sizeof *seen);
    for (int i = 0; i < lights->vpl_count; i++) {
        if (lights->vpls[i].reach <= 0)
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

struct vpl *vpls_read(const struct vpl_buffer *vpls) {
    size_t bytes = (size_t)vpls->count * sizeof(struct vpl);
    struct vpl *read = mem_alloc(bytes, 1);
    buffer_read(&vpls->buffer, 0, bytes, read);
    return read;
}

/* Of the first bounce. */
static void count_area_lights(struct lights *lights, const struct vpl_buffer *buffer) {
    struct vpl *areas = vpls_read(buffer);
    lights->area_count = buffer->count;
    for (int i = 0; i < buffer->count; i++)
        lights->area_used += areas[i].reach > 0;
    free(areas);
}

bool lights_read(struct lights *lights, struct renderer *renderer) {
    struct output_list outputs;
    *lights = (struct lights){0};
    renderer_outputs(renderer, &outputs);
    const struct vpl_buffer *vpls = output_vpls(&outputs);
    const struct val_output *vals = output_vals(&outputs);
    if (!vpls)
        return error_set("technique '%s' has no VPLs", renderer->technique->name);
    lights->vpl_count = vpls->count;
    lights->vpls = vpls_read(vpls);
    if (vals)
        read_centers(lights, vals->positions);
    const struct output *areas = output_find(&outputs, "light");
    if (areas && areas->kind == OUTPUT_VPLS)
        count_area_lights(lights, areas->source);
    count(lights);
    return true;
}

void lights_free(struct lights *lights) {
    mem_free(lights->vpls, lights->centers);
    *lights = (struct lights){0};
}
