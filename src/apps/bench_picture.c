#include "apps/bench_picture.h"

#include "measure/vpl_trace.h"

bool bench_picture_render(const struct bench_case *prepared, const struct stage *stage,
                          bool software, struct image *image) {
    struct renderer renderer;
    *image = (struct image){0};
    if (!bench_case_start(&renderer, prepared, stage, software))
        return false;
    renderer_render(&renderer);
    bool ok = renderer_read_layers(&renderer, image);
    renderer_free(&renderer);
    return ok;
}

bool bench_picture_trace(const struct bench_case *prepared, const struct stage *stage,
                         bool software, struct image *image) {
    /* The VPLs do not depend on the picture's size, and a frame of few pixels costs little. */
    struct bench_case small = *prepared;
    struct renderer renderer;
    *image = (struct image){0};
    small.width = small.height = 16;
    if (!bench_case_start(&renderer, &small, stage, software))
        return false;
    renderer_render(&renderer);
    bool ok = vpl_trace(&renderer, prepared->width, prepared->height, NULL, image);
    renderer_free(&renderer);
    return ok;
}
